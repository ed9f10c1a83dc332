using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How head and neck follow what a creature looks at.</summary>
public readonly struct GazeSettings
{
    /// <summary>Sets how the head moves.</summary>
    /// <param name="rate">s⁻¹ of the critically damped approach; the head is nearly there after 4/rate. 10 is a cat, 4 a cow.</param>
    /// <param name="maxYaw">Radians to either side, 0..π.</param>
    /// <param name="maxUp">Radians above the horizontal, 0..π/2.</param>
    /// <param name="maxDown">Radians below it, 0..π/2.</param>
    /// <param name="fadeRate">s⁻¹ of the critically damped coming and going of attention: it is nearly there after 4/fadeRate.</param>
    /// <param name="backMargin">Radians to either side of straight behind in which the head stays on the side where it is, 0..π/2.</param>
    /// <param name="loseBeyond">Radians round from straight ahead beyond which a target is given up; π for never.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public GazeSettings(float rate, float maxYaw = 1.22f, float maxUp = 0.7f, float maxDown = 0.8f, float fadeRate = 10f, float backMargin = 0.5f, float loseBeyond = 3.1416f)
    {
        Finite.RequireWithin(rate, 0f, 1e4f, nameof(rate));
        Finite.RequireWithin(maxYaw, 0f, 3.1416f, nameof(maxYaw));
        Finite.RequireWithin(maxUp, 0f, 1.5708f, nameof(maxUp));
        Finite.RequireWithin(maxDown, 0f, 1.5708f, nameof(maxDown));
        Finite.RequireWithin(fadeRate, 0f, 1e4f, nameof(fadeRate));
        Finite.RequireWithin(backMargin, 0f, 1.5708f, nameof(backMargin));
        Finite.RequireWithin(loseBeyond, 0f, 3.1416f, nameof(loseBeyond));
        Rate = rate;
        MaxYaw = maxYaw;
        MaxUp = maxUp;
        MaxDown = maxDown;
        FadeRate = fadeRate;
        BackMargin = backMargin;
        LoseBeyond = loseBeyond;
    }

    /// <summary>10 s⁻¹; 70° to either side, 40° up, 46° down; never gives up a target behind.</summary>
    public static GazeSettings Default { get; } = new(10f);

    /// <summary>s⁻¹ of the critically damped approach.</summary>
    public float Rate { get; }

    /// <summary>Radians to either side.</summary>
    public float MaxYaw { get; }

    /// <summary>Radians above the horizontal.</summary>
    public float MaxUp { get; }

    /// <summary>Radians below it.</summary>
    public float MaxDown { get; }

    /// <summary>s⁻¹ of the critically damped coming and going of attention.</summary>
    public float FadeRate { get; }

    /// <summary>Radians to either side of straight behind in which the head stays on its side.</summary>
    public float BackMargin { get; }

    /// <summary>Radians round from straight ahead beyond which a target is given up.</summary>
    public float LoseBeyond { get; }
}
