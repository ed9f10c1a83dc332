using CreatureGen.Anatomy;

namespace CreatureGen.Sampling;

/// <summary>A choice with its relative probability.</summary>
internal readonly struct Weighted<T>
{
    public Weighted(T value, double weight)
    {
        Value = value;
        Weight = weight;
    }

    public T Value { get; }

    public double Weight { get; }
}

/// <summary>What the sampler knows of the family of a base body: tendencies, all as data.</summary>
internal sealed class FamilyProfile
{
    public FamilyProfile(string body) => Body = body;

    /// <summary>Name of the dominant base body.</summary>
    public string Body { get; }

    /// <summary>Probability of this family among walkers, fliers and swimmers, relative.</summary>
    public (double Walking, double Flying, double Swimming) Frequency { get; init; }

    /// <summary>Base bodies that mix well with it, best first.</summary>
    public string[] Partners { get; init; } = System.Array.Empty<string>();

    /// <summary>Plans of its walkers.</summary>
    public Weighted<BodyPlan>[] WalkingPlans { get; init; } = System.Array.Empty<Weighted<BodyPlan>>();

    /// <summary>Plans of its swimmers.</summary>
    public Weighted<BodyPlan>[] SwimmingPlans { get; init; } = System.Array.Empty<Weighted<BodyPlan>>();

    /// <summary>Plans of its fliers.</summary>
    public Weighted<BodyPlan>[] FlyingPlans { get; init; } = { new(BodyPlan.Flapping, 0.94), new(BodyPlan.Buzzing, 0.06) };

    /// <summary>Plans of a kind.</summary>
    public Weighted<BodyPlan>[] PlansOf(LocomotionKind kind) => kind switch
    {
        LocomotionKind.Walking => WalkingPlans,
        LocomotionKind.Flying => FlyingPlans,
        _ => SwimmingPlans,
    };

    /// <summary>Ring and segment of the eye.</summary>
    public (double Ring, double Segment) Eye { get; init; }

    /// <summary>Radius of the eye relative to the half width of the head.</summary>
    public double EyeSize { get; init; }

    /// <summary>Depth of the eye's centre below the skin, radii.</summary>
    public double EyeSink { get; init; }

    /// <summary>Share of the forward direction in the gaze.</summary>
    public double EyeForward { get; init; }

    /// <summary>Opening of the upper and lower lid, degrees.</summary>
    public (double Upper, double Lower) LidDegrees { get; init; }

    /// <summary>Probability of slit pupils.</summary>
    public double SlitPupils { get; init; }

    /// <summary>Strength of the bony face around the eye: socket, brow, cheekbone.</summary>
    public double Bone { get; init; }

    /// <summary>Heights of the brow and cheek swellings.</summary>
    public (double Brow, double Cheek) Swelling { get; init; }

    /// <summary>Ring of the lip corners; 0 without a mouth slit.</summary>
    public int MouthCorner { get; init; }

    /// <summary>Exponent of the muzzle's section.</summary>
    public double MuzzleSquareness { get; init; } = 2.2;

    /// <summary>Radius of a nostril relative to the muzzle's half width.</summary>
    public double Nostril { get; init; }

    /// <summary>Mood added to the face: positive frowns.</summary>
    public double Mood { get; init; }

    /// <summary>Probability of ears and of horns.</summary>
    public (double Ears, double Horns) HeadOrnament { get; init; }

    /// <summary>Probability of teeth when the mouth is open.</summary>
    public double Teeth { get; init; }

    /// <summary>Patterns of the coat.</summary>
    public Weighted<PatternKind>[] Patterns { get; init; } = System.Array.Empty<Weighted<PatternKind>>();
}
