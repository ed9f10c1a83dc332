using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Standing on ground that moves.</summary>
internal static class PlatformRide
{
    /// <summary>Takes feet and body along with the platform that most of its standing feet are on.</summary>
    /// <param name="feet">What the feet do.</param>
    /// <param name="frame">Where the body is.</param>
    /// <param name="ground">The ground.</param>
    /// <param name="up">Away from it.</param>
    /// <returns>Where the body is taken.</returns>
    public static RootPlace Carry(Span<Foot> feet, in RootPlace frame, IGround ground, Vector3 up)
    {
        if (!(ground is IMovingGround moving))
        {
            return frame;
        }

        Vector3 way = Vector3.Zero;
        float yaw = 0f;
        int down = 0;
        for (int i = 0; i < feet.Length; i++)
        {
            ref Foot foot = ref feet[i];
            Vector3 before = foot.Plan.From.Position;
            Quaternion heading = foot.Plan.From.Heading;
            foot.Plan.From.Follow(moving);
            foot.Plan.To.Follow(moving);
            if (foot.Phase == FootPhase.Stance)
            {
                way += foot.Plan.From.Position - before;
                Quaternion turn = Rotation.Multiply(foot.Plan.From.Heading, Rotation.Inverse(heading));
                yaw += 2f * Vec.Dot(new Vector3(turn.X, turn.Y, turn.Z), up) * (turn.W < 0f ? -1f : 1f);
                down++;
            }
        }

        if (down == 0)
        {
            return frame;
        }

        Quaternion turned = Rotation.Normalize(Rotation.Multiply(Rotation.FromAxisAngle(up, yaw / down), frame.Rotation));
        return new RootPlace(frame.Position + (way / down), turned, frame.Scale);
    }
}
