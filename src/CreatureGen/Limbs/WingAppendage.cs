using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>A pair of grown wings as the rig takes them.</summary>
internal static class WingAppendage
{
    /// <summary>Describes a pair.</summary>
    /// <param name="ring">Ring of the middle of the left wing's root.</param>
    /// <param name="joints">Shoulder, elbow, wrist, hand and tip of the left wing.</param>
    /// <param name="along">Shares of the span at these.</param>
    /// <param name="held">Whether the flank holds its rear edge.</param>
    public static Appendage Of(double ring, Vector3[] joints, float[] along, bool held) => new()
    {
        Kind = LimbKind.Wing,
        Paired = true,
        RootRing = ring,
        Joints = joints,
        JointsAlong = along,
        Pole = Vec.Normalize(Vec.Reject(joints[1] - joints[0], Vec.Normalize(joints[2] - joints[0])), Vector3.UnitY),
        Contact = joints[joints.Length - 1],
        Stands = false,
        HeldByFlank = held,
    };
}
