using System;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How eyes follow what a creature looks at.</summary>
public readonly struct EyeSettings
{
    /// <summary>Sets how eyes move.</summary>
    /// <param name="rate">s⁻¹ of the exponential approach; eyes are fast.</param>
    /// <param name="outward">Radians away from the nose, 0..π/2.</param>
    /// <param name="inward">Radians towards the nose, 0..π/2.</param>
    /// <param name="up">Radians, 0..π/2.</param>
    /// <param name="down">Radians, 0..π/2.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public EyeSettings(float rate, float outward = 0.6f, float inward = 0.5f, float up = 0.4f, float down = 0.4f)
    {
        Finite.RequireWithin(rate, 0f, 1e4f, nameof(rate));
        Finite.RequireWithin(outward, 0f, 1.5708f, nameof(outward));
        Finite.RequireWithin(inward, 0f, 1.5708f, nameof(inward));
        Finite.RequireWithin(up, 0f, 1.5708f, nameof(up));
        Finite.RequireWithin(down, 0f, 1.5708f, nameof(down));
        Rate = rate;
        Left = new AngleRange(-inward, outward);
        Pitch = new AngleRange(-down, up);
    }

    /// <summary>30 s⁻¹; 34° outward, 29° inward, 23° up and down.</summary>
    public static EyeSettings Default { get; } = new(30f);

    /// <summary>s⁻¹ of the exponential approach.</summary>
    public float Rate { get; }

    /// <summary>Yaw of the left eye; the right eye has the negated range.</summary>
    internal AngleRange Left { get; }

    /// <summary>Pitch of both.</summary>
    internal AngleRange Pitch { get; }
}
