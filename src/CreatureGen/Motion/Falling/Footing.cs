using System;
using System.Numerics;
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
        if (!IsMissing(body, legs, new GroundRange(root, settings.Up, ground, Above * body.LegLength, Below * body.LegLength)))
        {
            lost = 0f;
            return false;
        }

        bool again = lost > 0f;
        lost += Math.Max(dt, float.Epsilon);
        return again && lost >= Patience * (float)Math.Sqrt(body.LegLength * root.Scale / settings.Gravity);
    }

    /// <summary>Whether there is nothing below the middle, and that is neither between feet that have ground nor between places where they find some.</summary>
    private static bool IsMissing(LeggedBody body, WalkingMode legs, in GroundRange range)
    {
        if (range.Has(body.Middle, out _))
        {
            return false;
        }

        FootingSpread spread = FootingSpread.None;
        for (int i = 0; i < body.Legs.Length; i++)
        {
            ref readonly Foot foot = ref legs.Feet[i];
            bool stands = foot.Phase == FootPhase.Stance;
            Vector3 there = range.Root.ToModel(stands ? foot.Plan.From.Position : foot.Plan.Goal);
            if (range.Has(there, out _))
            {
                // Under the hip of one in the air it will be once the body has come up to it: in a leap all of them are ahead of the body, which flies on to them.
                spread.AddSole(body.Legs[i], there);
                spread.Add(stands ? there : body.Legs[i].Home);
            }
        }

        return !spread.Carries(body) && !GroundNearFeet.Carries(body, range, ref spread, out _);
    }
}
