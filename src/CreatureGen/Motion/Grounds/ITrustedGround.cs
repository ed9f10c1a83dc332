namespace CreatureGen.Motion.Grounds;

/// <summary>Ground of the library itself: it never throws, so that nothing need be kept for the case that it does.</summary>
internal interface ITrustedGround
{
}
