using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Wings that no plan asks for: a second pair on fliers, and a pair raised over the backs of walkers. How often follows the strangeness.</summary>
internal static class ExtraWings
{
    /// <summary>Probability of a second pair at full strangeness.</summary>
    private const double SecondPairs = 0.3;

    /// <summary>Probability of wings on a walker at full strangeness.</summary>
    private const double WingedWalkers = 0.3;

    /// <summary>Rings from the first pair to the second.</summary>
    private const int Behind = 7;

    /// <summary>Segments by which the second pair sits higher on the back: stout thighs begin below it.</summary>
    private const int AboveThighs = 1;

    /// <summary>Segments by which raised wings sit higher on the back of what has arms below them.</summary>
    private const int AboveArms = 2;

    // Longest raised wings in heights of the back, and length in torsos that they keep in any case: over short legs longer ones are a sail on a raft.
    private const double TallestRaised = 1.8;
    private const double MinRaised = 0.7;

    // The second pair against the first: smaller, lower and farther back, or the two look like one thick wing.
    private const double SecondSpan = 0.75;
    private const double SecondRise = 0.55;
    private const double SecondSweep = 0.25;

    /// <summary>Adds a second pair behind the only one of a flier, if it may have one and there is room.</summary>
    public static void AddBehind(CreatureBuilder builder)
    {
        if (builder.Stream("second wings").Chance(SecondPairs * builder.Strangeness) && builder.Wings.Count == 1)
        {
            WingBlueprint first = builder.Wings[0];
            SocketBlueprint socket = first.Socket with { Ring = first.Socket.Ring + Behind, Segment = first.Socket.Segment - AboveThighs };
            Add(builder, first with { Socket = socket, Span = first.Span * SecondSpan, Chord = first.Chord * SecondSpan, Rise = first.Rise * SecondRise, Sweep = first.Sweep + SecondSweep });
        }
    }

    /// <summary>Adds raised wings to a walker, if it may have them and stands on legs of other kinds than an insect's.</summary>
    public static void AddRaised(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("wings of a walker");
        bool winged = random.Chance(WingedWalkers * builder.Strangeness);
        WingStyle style = WingSampler.StyleOf(builder, random);
        double span = random.Uniform(0.75, 1.05) * WingSampler.CarriedTorso(builder);
        double rise = random.Uniform(0.7, 1);
        double sweep = random.Uniform(0.2, 0.4);
        if (winged && builder.Species.Class != AnimalClass.Arthropod && builder.Parents.Legs.Bird is null)
        {
            bool armed = builder.Plan is BodyPlan.Upright or BodyPlan.Centaur;
            SocketBlueprint socket = armed ? FlyingRules.RaisedWingSocket with { Segment = FlyingRules.RaisedWingSocket.Segment - AboveArms } : FlyingRules.RaisedWingSocket;
            WingForm form = WingForm.Of(style);
            span = Math.Min(span * form.Span, Math.Max(MinRaised * WingSampler.CarriedTorso(builder), TallestRaised * Back(builder)));
            Add(builder, new WingBlueprint(style, socket, span, WingSampler.DepthOf(builder, form, span), rise, sweep));
        }
    }

    /// <summary>Height of the back over the shoulders, metres.</summary>
    private static double Back(CreatureBuilder builder) => builder.Shape.Y[StationRing.Shoulder] + builder.Shape.Top[StationRing.Shoulder];

    private static void Add(CreatureBuilder builder, WingBlueprint wing)
    {
        if (builder.Sockets.IsFree(wing.Socket, 0) && builder.Sockets.TryReserve(wing.Socket, 0))
        {
            builder.Wings.Add(wing);
        }
    }
}
