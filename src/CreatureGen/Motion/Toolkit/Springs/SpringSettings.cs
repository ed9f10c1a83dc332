using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How spring bones move. May change from frame to frame without disturbing the motion.</summary>
public readonly struct SpringSettings
{
    /// <summary>Sets how bones move.</summary>
    /// <param name="frequency">Hz at which a bone swings about its animated direction, along the chain; 0 lets it hang.</param>
    /// <param name="dampingRatio">Below 1 it swings through, from 1 on it does not; along the chain.</param>
    /// <param name="radius">Model metres that it keeps from colliders, along the chain.</param>
    /// <param name="gravity">Acceleration in world space, m/s², on top of what the animated pose already shows; none by default.</param>
    /// <param name="maxSwing">Radians that a bone may leave its goal, above 0 to π.</param>
    /// <param name="inherit">How far a bone goes along when its parent leaves the animated pose: 0 keeps its own animated direction, 1 that relative to its parent.</param>
    /// <param name="inertia">How much of the movement of the whole creature the bones feel: 1 all of it (world space), 0 none (space of the creature).</param>
    /// <param name="weight">0 the animated pose, 1 the springs.</param>
    /// <param name="teleportDistance">World metres in one step beyond which the creature is taken to have been put elsewhere, not to have moved.</param>
    /// <param name="teleportAngle">Radians of turn in one step beyond which likewise.</param>
    /// <param name="maxSpeed">How fast a bone may swing, in parts of what it would swinging free over its full width: slower towards the ends of it, where it comes to rest. Not limited by default; of no effect where the frequency is 0.</param>
    /// <param name="drag">Part of its velocity through the air that a bone loses in a second, as a rate, along the chain: e^(−drag) of it is left; none by default. Apart from the damping of the spring, so that bones without stiffness come to rest too.</param>
    /// <param name="wind">Velocity of the air in world space, m/s; of effect where there is drag.</param>
    /// <param name="gravityFraction">Part of <paramref name="gravity"/> that a bone feels, along the chain; all of it by default.</param>
    /// <exception cref="ArgumentException">A number is outside its range or not finite.</exception>
    public SpringSettings(
        ChainCurve frequency,
        ChainCurve dampingRatio,
        ChainCurve radius = default,
        Vector3 gravity = default,
        float maxSwing = 0.55f,
        float inherit = 0.5f,
        float inertia = 1f,
        float weight = 1f,
        float teleportDistance = 5f,
        float teleportAngle = 2.4f,
        float maxSpeed = float.MaxValue,
        ChainCurve drag = default,
        Vector3 wind = default,
        ChainCurve? gravityFraction = null)
    {
        Finite.Require(gravity, nameof(gravity));
        Finite.RequireWithin(maxSwing, 1e-3f, 3.1416f, nameof(maxSwing));
        Finite.RequireWithin(inherit, 0f, 1f, nameof(inherit));
        Finite.RequireWithin(inertia, 0f, 1f, nameof(inertia));
        Finite.RequireWithin(weight, 0f, 1f, nameof(weight));
        Finite.RequireWithin(teleportDistance, 0f, float.MaxValue, nameof(teleportDistance));
        Finite.RequireWithin(teleportAngle, 0f, 4f, nameof(teleportAngle));
        Finite.Require(wind, nameof(wind));
        Finite.RequireWithin(maxSpeed, 0.01f, float.MaxValue, nameof(maxSpeed));
        Frequency = frequency;
        DampingRatio = dampingRatio;
        Radius = radius;
        Gravity = gravity;
        MaxSwing = maxSwing;
        Inherit = inherit;
        Inertia = inertia;
        Weight = weight;
        TeleportDistance = teleportDistance;
        TeleportAngle = teleportAngle;
        MaxSpeed = maxSpeed;
        Drag = drag;
        Wind = wind;
        GravityFraction = gravityFraction ?? new ChainCurve(1f);
    }

    /// <summary>Hz along the chain.</summary>
    public ChainCurve Frequency { get; }

    /// <summary>Damping ratio along the chain.</summary>
    public ChainCurve DampingRatio { get; }

    /// <summary>Model metres along the chain.</summary>
    public ChainCurve Radius { get; }

    /// <summary>World space, m/s².</summary>
    public Vector3 Gravity { get; }

    /// <summary>Radians that a bone may leave its goal.</summary>
    public float MaxSwing { get; }

    /// <summary>How far a bone goes along with its parent, 0..1.</summary>
    public float Inherit { get; }

    /// <summary>How much of the creature's movement the bones feel, 0..1.</summary>
    public float Inertia { get; }

    /// <summary>0 the animated pose, 1 the springs.</summary>
    public float Weight { get; }

    /// <summary>World metres.</summary>
    public float TeleportDistance { get; }

    /// <summary>Radians.</summary>
    public float TeleportAngle { get; }

    /// <summary>Parts of the speed of a free swing over the full width.</summary>
    public float MaxSpeed { get; }

    /// <summary>Rate at which velocity through the air is lost, s⁻¹, along the chain; below 0 counts as none.</summary>
    public ChainCurve Drag { get; }

    /// <summary>Part of <see cref="Gravity"/> along the chain.</summary>
    public ChainCurve GravityFraction { get; }

    /// <summary>World space, m/s.</summary>
    public Vector3 Wind { get; }

    /// <summary>A tail: slow, and damped so much that it trails and never pumps up in a gallop.</summary>
    /// <param name="length">Of the whole chain in the world, metres.</param>
    public static SpringSettings Tail(float length) => Swinging(length, 2.4, 1.2f);

    /// <summary>A soft ear: quicker, with a shake at the end.</summary>
    /// <param name="length">Of the ear in the world, metres.</param>
    public static SpringSettings Ear(float length) => Swinging(length, 2.6, 0.4f);

    /// <summary>A feeler.</summary>
    /// <param name="length">Of the feeler in the world, metres.</param>
    public static SpringSettings Antenna(float length) => Swinging(length, 2.2, 0.3f);

    /// <summary>A chain that swings so many times faster than a hanging rod of its length, √(1.5 g / length) / 2π; 1.9 times as fast at its root. No bone goes as fast as it would by itself from one end of its swing to the other: a jolt of the body would whip it there.</summary>
    private static SpringSettings Swinging(float length, double factor, float dampingRatio)
    {
        Finite.RequireWithin(length, 1e-6f, 1e6f, nameof(length));
        float tip = (float)(factor * Math.Sqrt(1.5 * StandardGravity.Precise / length) / PortableMath.Tau);
        return new SpringSettings(new ChainCurve(1.9f * tip, tip), new ChainCurve(dampingRatio), maxSpeed: 0.8f);
    }
}
