using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How far and how often an idle creature looks about.</summary>
public readonly struct GlanceSettings
{
    /// <summary>Sets range and rhythm.</summary>
    /// <param name="yaw">Radians to either side, 0..π.</param>
    /// <param name="pitch">Radians up and down, 0..π/2.</param>
    /// <param name="period">Mean seconds from glance to glance, above 0; single ones come up to 37 % earlier or later.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public GlanceSettings(float yaw, float pitch = 0.25f, float period = 1.935f)
    {
        Finite.RequireWithin(yaw, 0f, 3.1416f, nameof(yaw));
        Finite.RequireWithin(pitch, 0f, 1.5708f, nameof(pitch));
        Finite.RequireWithin(period, 0.1f, 3600f, nameof(period));
        Yaw = yaw;
        Pitch = pitch;
        Period = period;
    }

    /// <summary>0.85 rad to either side, 0.25 rad up and down, held for 0.8 to 2.4 s.</summary>
    public static GlanceSettings Default { get; } = new(0.85f);

    /// <summary>Radians to either side.</summary>
    public float Yaw { get; }

    /// <summary>Radians up and down.</summary>
    public float Pitch { get; }

    /// <summary>Mean seconds from glance to glance.</summary>
    public float Period { get; }
}
