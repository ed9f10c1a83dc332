using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Standing on ground that moves, and going over it.</summary>
internal static class PlatformRide
{
    /// <summary>Takes feet along with the platforms that they are on, and the body with its standing feet; with none down, with all of them, each on its way from where it stood to where it will: who leaps on a platform comes down on it where it would on ground that rests.</summary>
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

        Ride standing = default;
        Ride flying = default;
        for (int i = 0; i < feet.Length; i++)
        {
            ref Foot foot = ref feet[i];
            var from = Ride.Of(ref foot.Plan.From, moving, up);
            var to = Ride.Of(ref foot.Plan.To, moving, up);
            foot.Plan.TakeAlong(to.Way);
            if (foot.Phase == FootPhase.Stance)
            {
                standing.Add(from, 1f);
            }
            else
            {
                flying.Add(from, 1f - foot.Swing);
                flying.Add(to, foot.Swing);
            }
        }

        return standing.Weight > 0f ? standing.Take(frame, up) : flying.Take(frame, up);
    }

    /// <summary>How far places have been taken along.</summary>
    private struct Ride
    {
        private Vector3 before;
        private float yaw;

        /// <summary>How many there are.</summary>
        public float Weight { get; private set; }

        /// <summary>Sum of how far, world space.</summary>
        public Vector3 Way { get; private set; }

        /// <summary>Takes a place along with its platform.</summary>
        public static Ride Of(ref Foothold place, IMovingGround ground, Vector3 up)
        {
            Vector3 before = place.Position;
            Quaternion heading = place.Heading;
            place.Follow(ground);
            Quaternion turn = Rotation.Multiply(place.Heading, Rotation.Inverse(heading));
            return new Ride { before = before, Way = place.Position - before, yaw = 2f * Vec.Dot(new Vector3(turn.X, turn.Y, turn.Z), up) * (turn.W < 0f ? -1f : 1f) };
        }

        public void Add(in Ride other, float weight)
        {
            before += other.before * weight;
            Way += other.Way * weight;
            yaw += other.yaw * weight;
            Weight += weight;
        }

        /// <summary>Takes a body along, about the middle of the places.</summary>
        public readonly RootPlace Take(in RootPlace frame, Vector3 up)
        {
            Quaternion turn = Rotation.FromAxisAngle(up, yaw / Weight);
            Vector3 away = frame.Position - (before / Weight);
            return new RootPlace(frame.Position + (Way / Weight) + (Rotation.Rotate(turn, away) - away), Rotation.Normalize(Rotation.Multiply(turn, frame.Rotation)), frame.Scale);
        }
    }
}
