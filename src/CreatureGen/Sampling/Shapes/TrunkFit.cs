using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Trunks of strange creatures with a shape: on legs the even and endless bodies of snakes, newts and eels are logs, and swimmers that end as thick as they are in the middle are sacks.</summary>
internal static class TrunkFit
{
    // Longest trunks in chests: on legs under the body, upright, on legs out to its side, of swimmers, and of those that swim by winding.
    private const double LongestCarried = 2.9;
    private const double LongestUpright = 2.9;
    private const double LongestSprawling = 3.3;
    private const double LongestSwimmer = 2.7;
    private const double LongestWinding = 4.2;

    // Least length of a body that lies, from the neck to the end of its tail, in its thicknesses: a shorter one is a log with a face. What lacks it gains in length by this part, at most this, and by the rest it gives way in girth; its tail is at least this part of its trunk.
    private const double LeastLying = 11.5;
    private const double Lengthened = 0.62;
    private const double MostLengthened = 1.55;
    private const double LyingTail = 0.55;

    /// <summary>The part of a girth that gives way which the depth of the ends of the trunk gives way by as well: girth is by .7 of it depth.</summary>
    private const double RopeEnds = 0.2;

    // The part of what is too long that is taken from the length, and the part of the rest by which the trunk grows thicker.
    private const double Shortened = 0.45;
    private const double Thickened = 0.75;

    /// <summary>The part of the thickening that is depth, above all that of the chest; the rest is girth.</summary>
    private const double Deep = 0.5;

    /// <summary>Least factor on the length of a slice.</summary>
    private const double ShortestSlice = 0.6;

    // Slices of the lattice that lie in the trunk.
    private const int FirstSlice = 3;
    private const int LastSlice = 7;

    // Depth of the loin in chests that a belly is drawn in to, that of insects, which have a waist, and least factor that this asks for.
    private const double Tucked = 0.77;
    private const double Waist = 0.48;
    private const double LeastTuck = 0.72;

    /// <summary>Least factor of the same on an insect: with less of a waist it is a log on wires.</summary>
    private const double LeastWaist = 0.55;

    // The parts of a tuck that the chest gains and that the loin gives way by, and what of it shows on the belly between them.
    private const double Chest = 0.4;
    private const double Flank = 0.6;
    private const double Belly = 0.35;

    /// <summary>What the abdomen of an insect gains of a tuck: behind its waist it is the hips.</summary>
    private const double Abdomen = 0.8;

    /// <summary>What its waist gives way by.</summary>
    private const double Constriction = 0.45;

    // Steepest fall of a swimmer's throat to its chest for each unit that it goes back, and the parts of what is too much by which the chest and the rest of the trunk give way and the neck grows: behind a step the head is a spout on a sack.
    private const double SteepestThroat = 0.66;
    private const double ChestGives = 0.4;
    private const double BellyGives = 0.12;
    private const double NeckGrows = 0.1;
    private const double MostThroat = 1.8;
    private const int ThroatFirst = 14;
    private const int ThroatStep = 4;

    // The part of what a fish's or a whale's neck lacks to the line from its head to its ribs that it grows by, and most of it: behind a hollow one the head is a knob before a bulge.
    private const double HollowFilled = 0.7;
    private const double MostHollow = 1.5;

    // Deepest swimmer in lengths from the base of its neck to the pelvis, that of those that swim by winding, and the part of what is too much by which its depth gives way; the rest is girth.
    private const double DeepestSwimmer = 0.56;
    private const double DeepestWinding = 0.42;
    private const double Shallower = 0.5;

    // The part of a step down from the base of a swimmer's neck to its shoulder that the shoulder rises by, and most of it: the step is a corner of the back.
    private const double ShoulderRises = 0.7;
    private const double MostRisen = 1.25;
    private const int BehindShoulder = 28;

    // Deepest section of a swimmer that is no fish in its breadths, and what of the excess the depth and the breadth give way by: a deeper one is a plank on its edge.
    private const double Edgewise = 1.3;
    private const double EdgeShallower = 0.4;
    private const double EdgeBroader = 0.3;

    // Broadest section of a swimmer in its depths, and what of the excess the depth and the breadth give way by: a broader one is a plank. Shells are as flat as they are.
    private const double Flattest = 1.5;
    private const double FlatDeepened = 0.4;
    private const double FlatNarrowed = 0.25;

    // The same of a fish, and of what swims by winding: round ones are balls from behind. The depth and the breadth of a fish give way by these parts.
    private const double FlattestFish = 0.82;
    private const double FlattestWinding = 0.95;
    private const double FishDeepened = 0.1;
    private const double FishNarrowed = 0.7;

    // A swimmer's largest hips against its belly, the power of what they give way by for it that the belly follows by, for it would end in a corner before them, least and most of its tail's stem against its hips and belly, and most that the tail's girth changes by for it.
    private const double Hips = 0.57;
    private const double BellyFollows = 0.5;
    private const double Root = 0.5;
    private const double Stem = 0.42;
    private const double MaxRoot = 1.3;
    private const double MinRoot = 0.7;

    // By how much the chest, the belly, and the hips with the stem of the tail of swimmers are smaller and larger at most than the rules make them, as powers of e: fitted to one line all whales and eels have the same back and belly.
    private const double SmallerChest = 0.13;
    private const double SmallerBelly = 0.05;
    private const double LargerChest = 0.16;
    private const double LargerBelly = 0.06;
    private const double SlenderStock = 0.34;

    // Broadest trunk against its depth that legs under the body carry without looking like those of a table, and what of the excess the depth and the breadth give way by.
    private const double Broad = 1.25;
    private const double Deepened = 0.6;
    private const double Narrowed = 0.3;

    /// <summary>The slices with a shorter trunk where it is too long for its depth, and with a longer one where it lies and is too short.</summary>
    public static ValueList<LatticeSlice> Gather(CreatureBuilder builder)
    {
        LatticeSlice[] slices = builder.Slices.ToArray();
        BodyShape shape = StanceSampler.ShapeOf(builder);
        double length = builder.Plan == BodyPlan.Legless
            ? Math.Min(MostLengthened, PortableMath.Pow(Short(shape), Lengthened * builder.Fitting))
            : Math.Max(ShortestSlice, PortableMath.Pow(Length(builder, TrunkOutline.Of(shape)), -Shortened * builder.Fitting));
        for (int i = FirstSlice; i <= LastSlice; i++)
        {
            slices[i] = slices[i] with { Length = length * slices[i].Length };
        }

        return new ValueList<LatticeSlice>(slices);
    }

    /// <summary>The proportions with a deeper chest and a belly that is drawn in where the trunk is even, and a thicker trunk where it is long; swimmers thin out to the tail, what lies is a rope, and an upright one would be top-heavy on shorter legs.</summary>
    public static BodyProportions Fit(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        if (builder.Plan == BodyPlan.Legless)
        {
            return Rope(builder, drawn);
        }

        if (builder.Plan == BodyPlan.ManyLegged || builder.Species.Disc.Sweep != 0)
        {
            return drawn;
        }

        TrunkOutline outline = TrunkOutline.Of(StanceSampler.ShapeOf(builder));
        double thick = PortableMath.Pow(Length(builder, outline), Thickened * builder.Fitting);
        BodyProportions proportions = drawn with
        {
            Depth = drawn.Depth * PortableMath.Pow(thick, Deep),
            Girth = drawn.Girth * PortableMath.Pow(thick, 1 - Deep),
        };
        return builder.Kind == LocomotionKind.Swimming ? Streamlined(builder, proportions) : Tuck(builder, outline, proportions);
    }

    /// <summary>The proportions of a body that lies: slimmer where it is still short, with a tail.</summary>
    private static BodyProportions Rope(CreatureBuilder builder, BodyProportions drawn)
    {
        BodyShape shape = StanceSampler.ShapeOf(builder);
        double slimmer = PortableMath.Pow(Short(shape), -builder.Fitting);
        double trunk = shape.Arc[StationRing.TorsoLast] - shape.Arc[StationRing.NeckBase];
        double tail = Math.Max(1, LyingTail * trunk / (shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.TorsoLast]));
        return drawn with
        {
            Girth = drawn.Girth * slimmer,
            Chest = drawn.Chest * PortableMath.Pow(slimmer, RopeEnds),
            Rump = drawn.Rump * PortableMath.Pow(slimmer, RopeEnds),
            Tail = drawn.Tail * Math.Min(MostLengthened, PortableMath.Pow(tail, builder.Fitting)),
        };
    }

    /// <summary>How many times too short for its thickness a body is that lies, at least 1.</summary>
    private static double Short(BodyShape shape)
    {
        double thickest = 0;
        for (int ring = StationRing.NeckBase; ring <= StationRing.Pelvis; ring++)
        {
            thickest = Math.Max(thickest, 2 * Size(shape, ring));
        }

        return Math.Max(1, LeastLying * thickest / (shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.NeckBase]));
    }

    /// <summary>How many times as long as it may be a trunk is, at least 1.</summary>
    private static double Length(CreatureBuilder builder, TrunkOutline outline)
    {
        double longest = builder.Plan switch
        {
            BodyPlan.Legless or BodyPlan.ManyLegged or BodyPlan.Hexapod or BodyPlan.Buzzing => double.PositiveInfinity,
            BodyPlan.Upright => LongestUpright,
            BodyPlan.Sprawling => LongestSprawling,
            BodyPlan.Eel => LongestWinding,
            BodyPlan.Fish or BodyPlan.Whale or BodyPlan.Flipper => LongestSwimmer,
            _ => LongestCarried,
        };
        return builder.Species.Disc.Sweep != 0 ? 1 : Math.Max(1, outline.Slenderness / longest);
    }

    /// <summary>The proportions of a trunk on legs whose belly is drawn in behind a deeper chest where it is even, and that is not much broader than deep; one carried level or upright by two legs keeps its belly.</summary>
    private static BodyProportions Tuck(CreatureBuilder builder, TrunkOutline outline, BodyProportions drawn)
    {
        double strange = builder.Fitting;
        bool under = builder.Kind == LocomotionKind.Walking && (PlanTraits.IsAboveLegs(builder.Plan) || builder.Plan == BodyPlan.Theropod);
        bool insect = builder.Species.Class == AnimalClass.Arthropod;
        double excess = under ? Math.Max(1, outline.Breadth / Broad) : 1;
        bool even = builder.Plan is not (BodyPlan.Upright or BodyPlan.Theropod);
        double tuck = !even ? 1 : PortableMath.Pow(Scalar.Clamp((insect ? Waist : Tucked) / outline.Tuck, insect ? LeastWaist : LeastTuck, 1), strange);
        return drawn with
        {
            Chest = drawn.Chest * PortableMath.Pow(tuck, -Chest),
            Belly = drawn.Belly * PortableMath.Pow(tuck, Belly),
            Rump = drawn.Rump * PortableMath.Pow(tuck, insect ? Constriction : Flank),
            TailGirth = drawn.TailGirth * (insect ? PortableMath.Pow(tuck, -Abdomen) : 1),
            Depth = drawn.Depth * PortableMath.Pow(excess, Deepened * strange),
            Width = drawn.Width * PortableMath.Pow(excess, -Narrowed * strange),
        };
    }

    /// <summary>The proportions of a swimmer that thins out behind its belly instead of ending like a sack with a tail tied to it.</summary>
    private static BodyProportions Streamlined(CreatureBuilder builder, BodyProportions drawn)
    {
        double strange = builder.Fitting;
        BodyShape shape = StanceSampler.ShapeOf(builder);
        TrunkOutline outline = TrunkOutline.Of(shape);
        double deep = Math.Max(1, outline.Depth / (outline.Length * (builder.Plan == BodyPlan.Eel ? DeepestWinding : DeepestSwimmer)));
        double step = Math.Min(MostThroat, Math.Max(1, Throat(shape) / SteepestThroat));
        double hollow = builder.Plan is BodyPlan.Fish or BodyPlan.Whale ? Math.Min(MostHollow, Hollow(shape)) : 1;
        double corner = Scalar.Clamp(shape.Top[StationRing.NeckBase] / shape.Top[BehindShoulder], 1, MostRisen);
        double edge = builder.Species.Class == AnimalClass.Fish ? 1 : Math.Max(1, Narrowness(shape) / Edgewise);
        bool armoured = builder.Species.Disc.Sweep != 0 || builder.Shell.Style != ShellStyle.None;
        (double flattest, double deepened, double narrowed) = builder.Plan switch
        {
            BodyPlan.Fish => (FlattestFish, FishDeepened, FishNarrowed),
            BodyPlan.Eel => (FlattestWinding, FishDeepened, FishNarrowed),
            _ => (Flattest, FlatDeepened, FlatNarrowed),
        };
        double flat = armoured ? 1 : Math.Max(1, outline.Breadth / flattest);
        RandomStream figure = builder.Stream("figure of a swimmer");

        // A chest that gave way to the throat does not grow again.
        double chest = Drawn(SmallerChest, LargerChest * Math.Max(0, 1 - (4 * (step - 1))));
        double paunch = Drawn(SmallerBelly, LargerBelly);
        double stock = Drawn(SlenderStock, 0);
        double belly = Size(shape, StationRing.Belly);
        double hips = Size(shape, StationRing.Pelvis);
        double thin = Math.Min(1, Hips * stock * belly / hips);
        double root = Size(shape, StationRing.TailStem);
        double wanted = Math.Max(Root * thin * hips, Math.Min(Stem * stock * belly, root));
        return drawn with
        {
            Depth = drawn.Depth * PortableMath.Pow(deep, -Shallower * strange) * PortableMath.Pow(edge, -EdgeShallower * strange) * PortableMath.Pow(flat, deepened * strange),
            Width = drawn.Width * PortableMath.Pow(edge, EdgeBroader * strange) * PortableMath.Pow(flat, -narrowed * strange),
            Hump = drawn.Hump * PortableMath.Pow(corner, ShoulderRises * strange),
            Girth = drawn.Girth * PortableMath.Pow(deep, (Shallower - 1) * strange) * PortableMath.Pow(step, -BellyGives * strange),
            Chest = drawn.Chest * PortableMath.Pow(step, -ChestGives * strange) * chest,
            NeckGirth = drawn.NeckGirth * PortableMath.Pow(step, NeckGrows * strange) * PortableMath.Pow(hollow, HollowFilled * strange),
            Belly = drawn.Belly * PortableMath.Pow(thin, BellyFollows * strange) * paunch,
            Rump = drawn.Rump * PortableMath.Pow(thin, strange),
            TailGirth = drawn.TailGirth * Scalar.Clamp(PortableMath.Pow(wanted / root, strange), MinRoot, MaxRoot),
        };

        double Drawn(double smaller, double larger) => PortableMath.Exp(strange * figure.Uniform(-smaller, larger));
    }

    /// <summary>Greatest depth of a section between the girdles against its own breadth.</summary>
    private static double Narrowness(BodyShape shape)
    {
        double narrowest = 0;
        for (int ring = StationRing.Shoulder; ring <= StationRing.Pelvis; ring++)
        {
            narrowest = Math.Max(narrowest, 0.5 * (shape.Top[ring] + shape.Bottom[ring]) / shape.Width[ring]);
        }

        return narrowest;
    }

    /// <summary>Steepest fall of the line from the chin to the chest for each unit that it goes back.</summary>
    private static double Throat(BodyShape shape)
    {
        double steepest = 0;
        for (int ring = ThroatFirst; ring <= StationRing.Ribs; ring++)
        {
            double down = shape.Y[ring] - shape.Bottom[ring] - shape.Y[ring + ThroatStep] + shape.Bottom[ring + ThroatStep];
            steepest = Math.Max(steepest, down / (shape.Z[ring] - shape.Z[ring + ThroatStep]));
        }

        return steepest;
    }

    /// <summary>How many times as thick as it is a neck would be on the line from the head to the ribs, at least 1.</summary>
    private static double Hollow(BodyShape shape)
    {
        double hollow = 1;
        double head = Math.Max(Size(shape, StationRing.Brow), Size(shape, StationRing.Cranium));
        double ribs = Size(shape, StationRing.Ribs);
        for (int ring = StationRing.Nape; ring <= StationRing.NeckBase; ring++)
        {
            double fraction = (shape.Arc[ring] - shape.Arc[StationRing.Cranium]) / (shape.Arc[StationRing.Ribs] - shape.Arc[StationRing.Cranium]);
            hollow = Math.Max(hollow, Scalar.Lerp(head, ribs, fraction) / Size(shape, ring));
        }

        return hollow;
    }

    /// <summary>Radius of a section, metres.</summary>
    private static double Size(BodyShape shape, int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
}
