using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;

namespace CreatureGen.Motion.Falling;

/// <summary>Whether legs still have ground to stand on.</summary>
internal struct Footing
{
    /// <summary>How long there has to be no ground before a body counts as falling, τ = √(ℓ/g): one answer of a ground is not enough.</summary>
    private const float Patience = 0.25f;

    /// <summary>Where rays begin above the root, and how far below it ground carries the body, leg lengths.</summary>
    private const float Above = 0.8f;
    private const float Below = 0.9f;

    /// <summary>How far the body may be beyond its feet that have ground, leg lengths.</summary>
    private const float Overhang = 0.1f;

    private float lost;

    /// <summary>Whether a walker falls: it has had no ground for a while, and in more than one update.</summary>
    /// <param name="body">Its build.</param>
    /// <param name="legs">Give the feet.</param>
    /// <param name="root">Where it is.</param>
    /// <param name="dt">Seconds since it was asked last.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it is on.</param>
    public bool IsLost(LeggedBody body, WalkingMode legs, in RootPlace root, float dt, in MotionSettings settings, IGround ground)
    {
        if (!IsMissing(body, legs, root, settings.Up, ground))
        {
            lost = 0f;
            return false;
        }

        bool again = lost > 0f;
        lost += Math.Max(dt, float.Epsilon);
        return again && lost >= Patience * (float)Math.Sqrt(body.LegLength * root.Scale / settings.Gravity);
    }

    /// <summary>Whether there is nothing below the middle, and that is not between feet that have ground.</summary>
    private static bool IsMissing(LeggedBody body, WalkingMode legs, in RootPlace root, Vector3 up, IGround ground)
    {
        if (Carries(body, root, Vector3.Zero, up, ground))
        {
            return false;
        }

        float front = float.MinValue;
        float rear = float.MaxValue;
        float left = float.MinValue;
        float right = float.MaxValue;
        for (int i = 0; i < body.Legs.Length; i++)
        {
            ref readonly Foot foot = ref legs.Feet[i];
            bool stands = foot.Phase == FootPhase.Stance;
            Vector3 there = root.ToModel(stands ? foot.Plan.From.Position : foot.Plan.To.Position);
            if (Carries(body, root, there, up, ground))
            {
                // Under the hip of one in the air it will be once the body has come up to it: in a leap all of them are ahead of the body, which flies on to them.
                Vector3 then = stands ? there : body.Legs[i].Home;
                front = Math.Max(front, Math.Max(there.Z, then.Z));
                rear = Math.Min(rear, Math.Min(there.Z, then.Z));
                left = Math.Max(left, Math.Max(there.X, then.X));
                right = Math.Min(right, Math.Min(there.X, then.X));
            }
        }

        float over = Overhang * body.LegLength;
        return front < -over || rear > over || left < -over || right > over;
    }

    private static bool Carries(LeggedBody body, in RootPlace root, Vector3 place, Vector3 up, IGround ground)
    {
        Vector3 from = root.ToWorld(new Vector3(place.X, Above * body.LegLength, place.Z));
        return ground.Cast(from, -up, (Above + Below) * body.LegLength * root.Scale, out _);
    }
}
