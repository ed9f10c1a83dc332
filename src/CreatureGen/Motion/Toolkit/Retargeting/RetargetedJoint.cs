using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Retargeting;

/// <summary>A joint that turns as others do.</summary>
/// <param name="Joint">Which.</param>
/// <param name="Before">The joint that it follows.</param>
/// <param name="After">Another that it follows.</param>
/// <param name="Part">How much of the second, 0..1.</param>
/// <param name="Align">Turns its limb from its own rest to that of the other skeleton, model space.</param>
/// <param name="Slide">Metres that it slides for each of the other; 0 for what only turns.</param>
internal readonly record struct RetargetedJoint(int Joint, int Before, int After, float Part, Quaternion Align, float Slide = 0f);

/// <summary>A leg whose foot goes where another does.</summary>
/// <param name="Chain">From the hip to the foot, each the parent of the next.</param>
/// <param name="Foot">The joint of the other skeleton that the foot follows.</param>
internal readonly record struct RetargetedLeg(int[] Chain, int Foot);
