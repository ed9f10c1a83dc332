using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>What a ragdoll is made of. May change from frame to frame.</summary>
public readonly struct RagdollSettings
{
    /// <summary>s⁻¹: beyond that nothing moves anyway.</summary>
    private const float MaxDamping = 1e4f;

    /// <summary>Sets the material.</summary>
    /// <param name="gravity">World space, m/s²; up to 1 000 along each axis.</param>
    /// <param name="jointDamping">s⁻¹, 0 to 10⁴, at which neighbouring bones lose their turning against each other; flesh is not oiled.</param>
    /// <param name="airDamping">s⁻¹, 0 to 10⁴, at which everything slows down.</param>
    /// <param name="friction">Coefficient on the ground, 0 to 100.</param>
    /// <param name="tone">s⁻¹, 0 to 10⁴, at which joints go to the pose given, as if by muscles; 0 is limp.</param>
    /// <exception cref="ArgumentException">A number is outside its range or not finite.</exception>
    public RagdollSettings(Vector3 gravity, float jointDamping = 12f, float airDamping = 0.5f, float friction = 0.7f, float tone = 0f)
    {
        Finite.RequireWithin(gravity, 1000f, nameof(gravity));
        Finite.RequireWithin(jointDamping, 0f, 1e4f, nameof(jointDamping));
        Finite.RequireWithin(airDamping, 0f, MaxDamping, nameof(airDamping));
        Finite.RequireWithin(friction, 0f, 100f, nameof(friction));
        Finite.RequireWithin(tone, 0f, 1e4f, nameof(tone));
        Gravity = gravity;
        JointDamping = jointDamping;
        AirDamping = airDamping;
        Friction = friction;
        Tone = tone;
    }

    /// <summary>Limp flesh on dry ground, on Earth.</summary>
    public static RagdollSettings Default { get; } = new(new Vector3(0f, -StandardGravity.Acceleration, 0f));

    /// <summary>The same with more damping of everything.</summary>
    internal RagdollSettings Slowed(float damping) => new(Gravity, JointDamping, Math.Min(AirDamping + damping, MaxDamping), Friction, Tone);

    /// <summary>World space, m/s².</summary>
    public Vector3 Gravity { get; }

    /// <summary>s⁻¹.</summary>
    public float JointDamping { get; }

    /// <summary>s⁻¹.</summary>
    public float AirDamping { get; }

    /// <summary>Coefficient.</summary>
    public float Friction { get; }

    /// <summary>s⁻¹.</summary>
    public float Tone { get; }
}
