using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Sampling.Parents;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling;

/// <summary>A creature while it is being sampled: what has been decided so far.</summary>
internal sealed class CreatureBuilder
{
    /// <summary>Read by nobody before the body is shaped: one for all.</summary>
    private static readonly BodyShape unshaped = new();

    public CreatureBuilder(Seed seed, LocomotionKind kind, Parentage parents, BodyPlan plan, double strangeness)
    {
        Seed = seed;
        Kind = kind;
        Parents = parents;
        Plan = plan;
        Strangeness = strangeness;
        Shell = Harmony.ShellOf(parents, plan);
    }

    /// <summary>Root of the creature's seed tree.</summary>
    public Seed Seed { get; }

    public LocomotionKind Kind { get; }

    /// <summary>The species that it is mixed of, and which of them gives what.</summary>
    public Parentage Parents { get; }

    /// <summary>The species that the trunk starts from.</summary>
    public SpeciesProfile Species => Parents.First;

    /// <summary>How far it may be from any animal, 0..1.</summary>
    public double Strangeness { get; }

    /// <summary>How far parts are fitted to bodies that are not their own, 0..1: not at all on animals, wholly from half of the strangeness on.</summary>
    public double Fitting => Math.Min(1, 2 * Strangeness);

    /// <summary>Fewest and most pairs of legs and arms that are asked for: what can stand on any number of legs grows one within them.</summary>
    public int MinLegPairs { get; init; }

    public int MaxLegPairs { get; init; } = LegRow.Max;

    /// <summary>How it carries its body; a swimmer without room for its fins gets another.</summary>
    public BodyPlan Plan { get; set; }

    public Signature Signature { get; set; }

    /// <summary>Normal: cute and round when positive, lean when negative. Head, eyes, feet and stoutness follow it together.</summary>
    public double Style { get; set; }

    public BodyBlend Blend { get; set; } = BodyFields.Blend.Neutral;

    public BodyProportions Proportions { get; set; } = new(1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1);

    public BodyPosture Posture { get; set; } = new(0, 0, 0, 0, 0, 0, 0);

    /// <summary>The posture before it was settled.</summary>
    public BodyPosture Drawn { get; set; } = new(0, 0, 0, 0, 0, 0, 0);

    public ValueList<LatticeSlice> Slices { get; set; } = ValueList<LatticeSlice>.Empty;

    public TailBlueprint Tail { get; set; } = new(TailStyle.Plain, 0, 0);

    public double Elevation { get; set; }

    public DiscBlueprint Disc { get; set; } = new(0, 0);

    public ShellBlueprint Shell { get; set; }

    /// <summary>The trunk as drawn so far.</summary>
    public BodyBlueprint Body => BodyAt(Elevation);

    /// <summary>The body as it stands, its head still without a face.</summary>
    public BodyShape Shape { get; set; } = unshaped;

    /// <summary>The body that was shaped last, at elevation 0, and its shape: what is asked for again is not shaped again.</summary>
    public (BodyPlan Plan, BodyBlueprint Body, TailBlueprint Tail, BodyShape Shape)? Shaped { get; set; }

    /// <summary>The shape whose torso was measured last, with the weight of an open mouth.</summary>
    public (BodyShape Shape, SpineMeasure Measure)? Measured { get; set; }

    /// <summary>Length of the torso that heights are measured against, metres.</summary>
    public double TorsoLength { get; set; }

    /// <summary>Hip height that the plan asks for, metres.</summary>
    public double HipHeight { get; set; }

    /// <summary>Added to the share of its plan's range of heights at which the body is carried.</summary>
    public double StanceShift { get; set; }

    /// <summary>Whether it lies or stands on the ground: what hangs from it must stay clear of that.</summary>
    public bool IsOnGround => Kind == LocomotionKind.Walking || Stand != null;

    /// <summary>How far the attachment rules raised the body for its legs, metres.</summary>
    public double Raised { get; set; }

    /// <summary>Whether the rules found a stance in which its legs carry it.</summary>
    public bool IsCarried { get; set; } = true;

    /// <summary>The places of its standing legs and their size; null when it does not stand on legs.</summary>
    public LegStand? Stand { get; set; }

    public List<LegBlueprint> Legs { get; } = new();

    public List<WingBlueprint> Wings { get; } = new();

    public List<InsectWingBlueprint> InsectWings { get; } = new();

    public List<FinBlueprint> Fins { get; } = new();

    public List<EarBlueprint> Ears { get; } = new();

    public List<FeatureBlueprint> Features { get; } = new();

    public List<ManeBlueprint> Manes { get; } = new();

    public List<FrillBlueprint> Frills { get; } = new();

    /// <summary>Cells of the body that are taken.</summary>
    public SocketGrid Sockets { get; } = new();

    /// <summary>The trunk as drawn so far, at an elevation.</summary>
    public BodyBlueprint BodyAt(double elevation) => new(Blend, Proportions, Posture, Slices, elevation, Shell, Species.Annuli, Disc);

    /// <summary>The random numbers of one named decision.</summary>
    public RandomStream Stream(string name) => Seed.Child(name).Stream();

    /// <summary>Half of top plus bottom at a ring, metres.</summary>
    public double HalfDepth(int ring) => (Shape.Top[ring] + Shape.Bottom[ring]) / 2;

    /// <summary>A uniform draw, clamped normal about 1.</summary>
    public static double Around(RandomStream random, double mean, double deviation, double min, double max) =>
        Scalar.Clamp(random.Normal(mean, deviation), min, max);

    /// <summary>A uniform draw from a range.</summary>
    public static double Between(RandomStream random, (double Min, double Max) range) => random.Uniform(range.Min, range.Max);

    /// <summary>One of several weighted choices.</summary>
    public static T Choose<T>(RandomStream random, params (T Value, double Weight)[] choices)
    {
        double[] weights = new double[choices.Length];
        for (int i = 0; i < choices.Length; i++)
        {
            weights[i] = choices[i].Weight;
        }

        return choices[random.Weighted(weights)].Value;
    }

    /// <summary>One of several weighted choices.</summary>
    public static T Choose<T>(RandomStream random, Weighted<T>[] choices)
    {
        double[] weights = new double[choices.Length];
        for (int i = 0; i < choices.Length; i++)
        {
            weights[i] = choices[i].Weight;
        }

        return choices[random.Weighted(weights)].Value;
    }
}
