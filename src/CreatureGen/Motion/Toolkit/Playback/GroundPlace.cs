using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Playback;

/// <summary>The part of a root joint's motion that carries a creature over the ground: where it is on the plane, and which way it faces.</summary>
/// <param name="Place">Metres, no height.</param>
/// <param name="Heading">Radians about +Y; positive is to the left.</param>
internal readonly record struct GroundPlace(Vector3 Place, float Heading)
{
    /// <summary>What a joint's position and rotation hold of it. The heading is the twist about +Y.</summary>
    public static GroundPlace Of(Vector3 position, Quaternion rotation) => new(
        new Vector3(position.X, 0f, position.Z),
        rotation.Y == 0f && rotation.W == 0f ? 0f : (float)(2 * PortableMath.Atan2(rotation.Y, rotation.W)));

    /// <summary>One way after another.</summary>
    public static RootDelta Then(in RootDelta first, in RootDelta second) =>
        new(first.Shift + Rotation.Rotate(AxisRotation.Yaw(first.Turn), second.Shift), first.Turn + second.Turn);

    /// <summary>The way from here to another.</summary>
    public RootDelta To(in GroundPlace other)
    {
        double turn = other.Heading - Heading;
        return new RootDelta(
            Rotation.Rotate(AxisRotation.Yaw(-Heading), other.Place - Place),
            (float)(turn - (Math.Round(turn / PortableMath.Tau) * PortableMath.Tau)));
    }

    /// <summary>What is left of a position and a rotation that have travelled from here to another.</summary>
    public void TakeBack(in GroundPlace other, ref Vector3 position, ref Quaternion rotation)
    {
        position = new Vector3(Place.X, position.Y, Place.Z);
        rotation = Rotation.Normalize(Rotation.Multiply(AxisRotation.Yaw(Heading - other.Heading), rotation));
    }
}
