using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;

namespace CreatureGen.Motion.Falling;

/// <summary>How a creature lies on its belly with its legs folded under it, and gets up from there: as it does by itself, in the act of lying down. Immutable.</summary>
/// <param name="Act">The act; what follows its phase that lasts is the rise.</param>
/// <param name="Gain">How much of it the body does.</param>
/// <param name="Tempo">Factor on its times.</param>
/// <param name="Body">Its body as acts see it.</param>
/// <param name="Room">How far its trunk goes, and where its legs fold.</param>
internal sealed record LyingManner(Act Act, ActGain Gain, float Tempo, ActBody Body, TrunkRoom Room);
