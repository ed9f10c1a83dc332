namespace CreatureGen.Motion.Slithering;

/// <summary>What a crawler is to do, and where its root is.</summary>
/// <param name="Mode">How it crawls; a change passes down the body as it moves on.</param>
/// <param name="Speed">Metres of the model per second on its way, not negative; less counts as 0.</param>
/// <param name="YawRate">Radians per second by which the head turns its way; positive turns left. A crawler that does not move cannot turn, and none turns tighter than its body bends.</param>
/// <param name="Root">Where its root is; of its rotation the heading counts.</param>
/// <param name="SpeedResponse">How quickly its speed follows, a factor.</param>
internal readonly record struct SlitherInput(SlitherGait Mode, float Speed, float YawRate, RootPlace Root, float SpeedResponse = 1f);
