using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>How one spring bone moves. Fields, so that what is asked of one is not asked of a copy.</summary>
internal readonly struct SpringTone
{
    /// <summary>One substep of its spring.</summary>
    public readonly DampedSpring Step;

    /// <summary>Square of the greatest speed of its swing as part of the width that is left of it, s⁻².</summary>
    public readonly float Liveliness;

    /// <summary>Part of the velocity through the air that is left after a substep.</summary>
    public readonly float Slowed;

    /// <summary>Part of gravity that it feels.</summary>
    public readonly float GravityFraction;

    /// <summary>What it keeps from colliders, model metres.</summary>
    public readonly float Radius;

    public SpringTone(DampedSpring step, float liveliness, float slowed, float gravityFraction, float radius)
    {
        Step = step;
        Liveliness = liveliness;
        Slowed = slowed;
        GravityFraction = gravityFraction;
        Radius = radius;
    }
}
