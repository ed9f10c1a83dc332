using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How a body lies: its turn away from rest as yaw, pitch and roll. It goes from one to another by the shorter side, which turns between quaternions do not: near half a turn they stand on their heads.</summary>
/// <param name="Yaw">To the left, radians.</param>
/// <param name="Pitch">Nose down.</param>
/// <param name="Roll">Left side up.</param>
internal readonly record struct BodyTurn(float Yaw, float Pitch, float Roll)
{
    /// <summary>Parts of a time within which it pitches and rolls.</summary>
    private static readonly TimeWindow pitching = new(0.15f, 0.9f);
    private static readonly TimeWindow rolling = new(0.2f, 1f);

    /// <summary>The turn of a pose.</summary>
    public static BodyTurn Of(FallProfile profile, in Pose local)
    {
        int body = profile.Body;
        Quaternion carrier = Carrier(profile.Skeleton, body);
        Quaternion turn = Rotation.Normalize(Rotation.Multiply(Rotation.Multiply(carrier, local.Rotations[body]), Rotation.Inverse(profile.Skeleton.ModelRotations[body])));
        Vector3 ahead = Rotation.Rotate(turn, Vector3.UnitZ);
        float level = Vec.Length(new Vector3(ahead.X, 0f, ahead.Z));
        double yaw = level > 1e-3f ? PortableMath.Atan2(ahead.X, ahead.Z) : 0;
        double pitch = -PortableMath.Atan2(ahead.Y, level);
        Quaternion rest = Rotation.Multiply(Rotation.Inverse(AxisRotation.YawPitchRoll((float)yaw, (float)pitch, 0f)), turn);
        double roll = 2 * PortableMath.Atan2(rest.W < 0f ? -rest.Z : rest.Z, rest.W < 0f ? -rest.W : rest.W);
        return new BodyTurn((float)yaw, (float)pitch, (float)roll);
    }

    /// <summary>The way from one to the other.</summary>
    /// <param name="from">At 0.</param>
    /// <param name="to">At 1.</param>
    /// <param name="u">Part of the time, 0..1.</param>
    public static BodyTurn Between(in BodyTurn from, in BodyTurn to, float u) => new(
        Scalar.Lerp(from.Yaw, to.Yaw, pitching.At(u)),
        Scalar.Lerp(from.Pitch, to.Pitch, pitching.At(u)),
        Scalar.Lerp(from.Roll, to.Roll, rolling.At(u)));

    /// <summary>Turns the body of a pose.</summary>
    public void Set(FallProfile profile, in Pose local)
    {
        int body = profile.Body;
        Quaternion turned = Rotation.Multiply(AxisRotation.YawPitchRoll(Yaw, Pitch, Roll), profile.Skeleton.ModelRotations[body]);
        local.Rotations[body] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(Carrier(profile.Skeleton, body)), turned));
    }

    private static Quaternion Carrier(Skeleton skeleton, int joint) => skeleton.Parents[joint] < 0 ? Quaternion.Identity : skeleton.ModelRotations[skeleton.Parents[joint]];
}
