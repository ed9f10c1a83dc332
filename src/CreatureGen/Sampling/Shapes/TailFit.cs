using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Tails of strange creatures in proportion to their trunks: one that swells behind the rump is a sack that the creature drags.</summary>
internal static class TailFit
{
    /// <summary>Largest tail against its trunk, each at its largest section.</summary>
    private const double Size = 0.8;

    /// <summary>The same of a mixed insect's abdomen: from behind it is nearer than the rest and hides it.</summary>
    private const double LargestAbdomen = 0.7;

    // Largest root of a tail against the hips, behind legs under the body and of one that balances a body on two legs or in the air: one as thick as they are goes on as trunk, and has no rump before it.
    private const double LargestRoot = 0.5;
    private const double LargestBalancing = 0.62;

    // Longest tail against the trunk: of one that is carried up, which is a rod over the back, and of all others.
    private const double Carried = 0.75;
    private const double Trailing = 1.5;

    // Least length in radii of its root of a tail that rolls up, of others of a family, of one as the tables give it that balances a body, and of one that is carried over the ground without hair on it: shorter ones are knots and pegs. They give way in girth by this part of what lacks, by the rest in length.
    private const double LeastRolled = 9;
    private const double LeastTapered = 8.5;
    private const double LeastBalancing = 7.5;
    private const double LeastCarried = 10;
    private const double Slimmed = 0.6;

    // How far a bare tail behind legs under the body falls at least, and how far its tip bends back out, degrees: one that is held up is a spike from behind. A tail that balances a body on two legs falls less.
    private const double HungDegrees = 34;
    private const double TipDegrees = 22;
    private const double BalancingDegrees = 13;

    /// <summary>Least that the last third of a bare tail falls behind the rump, degrees: one that bends up to the level has a round end for who is behind it.</summary>
    private const double TipFallDegrees = 16;

    /// <summary>By how much that of a tail behind what rows differs from creature to creature: all alike, bodies of one build are doubles of one another.</summary>
    private const double RowersDiffer = 5;

    /// <summary>The same of a bare tail behind an upright body, which is seen between its legs from the front where it falls further.</summary>
    private const double UprightDegrees = 16;

    /// <summary>The same of a bare tail behind legs out to the side: one that rises is a round end from behind.</summary>
    private const double TrailingDegrees = 9;

    /// <summary>The same of a tail with a tuft or a club at its end, which is a ball on the rump where it is level.</summary>
    private const double WeightedDegrees = 15;

    /// <summary>The same of a bare tail of a flier: a level one is not seen from behind, and the rump is a block.</summary>
    private const double FlownDegrees = 16;

    // The same of a swimmer's with flukes or without a fin, within what its spine may slope, and of what rows, whose tail is short.
    private const double FlukeDegrees = 9;
    private const double RowingDegrees = 15;

    // How far a fluke itself comes down at least and at most, how far the tail before it does at most, by how much all three differ from creature to creature, the part of a bend of the whole tail that shows in its fluke, and how often both are set by turns: steeper flukes are tents from behind, level ones are bars there, and those that turn up bowls on posts.
    private const double FlattestFluke = 11;
    private const double SteepestFluke = 16;
    private const double SteepestStalk = 13;
    private const double FlukesDiffer = 4;
    private const double BendAtFluke = 0.8;
    private const int Rounds = 3;

    // How far a tail that rolls up on a mixed body comes down before it does, degrees, behind legs under the body and behind others: one that rises from its root on is a spike over the back from behind.
    private const double RolledFallDegrees = 64;
    private const double RolledFallOnOthers = 54;

    /// <summary>The same, for its end against its root: those of fish and newts rise by themselves.</summary>
    private const double RolledLeastFall = 22;

    /// <summary>How much more steeply a tail with a sting leaves the rump, degrees, so that it bends over the back: one that ends upright is a mast from behind.</summary>
    private const double StingDegrees = 27;

    // Least and most that an abdomen comes down, and how far its end bends back out: a level one is a ball from behind, one that turns down at its end looks cut off there.
    private const double LeastAbdomenDegrees = 12;
    private const double AbdomenDegrees = 19;
    private const double StraightenedDegrees = 13;

    // Least fall of a fan of feathers behind the rump, that of a strange creature that flies, that behind four legs, where a shorter one is an apron from behind, and rise from which on a fan is carried up as a cock's is.
    private const double FallDegrees = 18;
    private const double FlownFallDegrees = 19;
    private const double FallOnFourLegs = 32;
    private const double RaisedDegrees = 30;

    // How far a tail may come down for each unit that it goes back, one that balances a body on two legs, and one of an upright body: from the front they are a keel between the legs.
    private const double SteepestTail = 1.1;
    private const double SteepestBalanced = 0.45;
    private const double SteepestOfUpright = 0.75;

    /// <summary>The same of one that flies: it may stand on two legs.</summary>
    private const double SteepestFlown = 0.5;

    // Least tail of what flies and of what balances on two legs, against the trunk, that of others whose tail is of a family or bare, and most that it is made longer by: without one the trunk ends like a block behind the legs.
    private const double LeastTail = 0.35;
    private const double LeastOfFamily = 0.5;
    private const double MostLonger = 2.4;

    // The same of a swimmer that is driven by its tail, and longest factor on a tail that it asks for: on a short one the trunk ends in a wall with a fin on it.
    private const double LeastDriven = 0.5;
    private const double LongestDriven = 3.6;

    /// <summary>The same of one that rows, without a shell: behind a short tail its rump is a ball with a nipple.</summary>
    private const double LeastRowing = 0.48;

    /// <summary>Least girth that is left of a tail.</summary>
    private const double MinGirth = 0.5;

    // Rings of the trunk between the girdles, and of the tail behind its root.
    private const int FirstOfTrunk = 25;
    private const int LastOfTrunk = 42;
    private const int FirstOfTail = 47;
    private const int LastThird = 51;
    private const int LastOfTail = 54;

    // Largest section at two thirds of a tail as the tables give it and at its tip, in its largest one, and the parts of what is too much that the last slices but one and the last give way by: what ends as thick as it is before is a finger from behind.
    private static readonly (double Min, double Max) largestEnd = (0.26, 0.46);
    private const double LargestTip = 0.1;
    private const double BeforeEnd = 0.7;
    private const double AtEnd = 1.8;

    /// <summary>The same of an abdomen, which is to run out instead of ending in a bulge.</summary>
    private static readonly double[] abdomen = { 0.85, 0.68, 0.5 };

    /// <summary>Girths of the last slices of a bird's tail without feathers, the tip last, relative to what its tables give.</summary>
    private static readonly double[] featherless = { 0.8, 0.6, 0.35 };

    /// <summary>The same of a swimmer's tail, which ends in a fin or runs out in a point.</summary>
    private static readonly double[] finless = { 0.9, 0.7, 0.4 };

    /// <summary>The proportions with a thinner tail where it is too thick, and a shorter one where it is too long; swimmers and what crawls move by theirs, and insects bear a thick abdomen.</summary>
    public static BodyProportions Fit(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        if (HasAbdomen(builder))
        {
            BodyShape insect = StanceSampler.ShapeOf(builder);
            double bulges = Math.Max(1, Largest(insect, FirstOfTail, LastOfTail) / (LargestAbdomen * Largest(insect, FirstOfTrunk, LastOfTrunk)));
            return drawn with { TailGirth = drawn.TailGirth * PortableMath.Pow(bulges, -builder.Fitting) };
        }

        if (builder.Kind == LocomotionKind.Swimming || builder.Species.Class == AnimalClass.Arthropod || builder.Plan == BodyPlan.Legless)
        {
            return drawn;
        }

        BodyShape shape = StanceSampler.ShapeOf(builder);
        double size = Largest(shape, FirstOfTail, LastOfTail) / Largest(shape, FirstOfTrunk, LastOfTrunk);
        double largest = PlanTraits.IsAboveLegs(builder.Plan) ? LargestRoot : builder.Plan is BodyPlan.Flapping or BodyPlan.Theropod && builder.Species.Class != AnimalClass.Bird ? LargestBalancing : double.PositiveInfinity;
        double root = Largest(shape, StationRing.TailStem, StationRing.TailStem) / Largest(shape, StationRing.Pelvis, StationRing.Pelvis);
        double excess = Math.Max(1, Math.Max(size / Size, root / largest));
        double strange = builder.Fitting;
        double length = LengthOf(shape);
        TailTaper? taper = TailTaper.Of(builder.Tail.Style);
        bool rolls = taper is { Curl: not 0 };
        bool steers = builder.Plan is BodyPlan.Flapping or BodyPlan.Theropod && builder.Tail.Style is TailStyle.Plain or TailStyle.Saurian
            && (builder.Parents.Tail.Class != AnimalClass.Bird || builder.Species.Class != AnimalClass.Bird);
        bool bare = IsBare(builder);
        double slender = rolls ? LeastRolled : bare ? LeastCarried : taper != null ? LeastTapered : steers ? LeastBalancing : 0;
        double stubby = Math.Max(1, slender * Largest(shape, FirstOfTail, FirstOfTail) / (shape.Arc[LastOfTail] - shape.Arc[StationRing.TorsoLast]));
        bool fanned = (builder.Plan == BodyPlan.Flapping || PlanTraits.IsAboveLegs(builder.Plan)) && builder.Tail.Style == TailStyle.Feathers && builder.Species.Class != AnimalClass.Bird;
        double shortest = steers || fanned ? LeastTail : bare || (taper != null && !rolls) ? LeastOfFamily : 0;
        double longer = Math.Min(MostLonger, Math.Max(shortest / length, PortableMath.Pow(stubby, 1 - Slimmed)));
        return drawn with
        {
            Tail = drawn.Tail * PortableMath.Pow(longer / Math.Max(1, length / (rolls ? Carried : Trailing)), strange),
            TailGirth = drawn.TailGirth * Math.Max(MinGirth, PortableMath.Pow(excess * PortableMath.Pow(stubby, Slimmed), -strange)),
        };
    }

    /// <summary>The proportions with a longer tail of a swimmer that is driven by it or would have a stub, before its trunk is fitted to the length that is left to it.</summary>
    public static BodyProportions Drive(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        bool rows = builder.Plan == BodyPlan.Flipper && builder.Shell.Style == ShellStyle.None;
        if (!(rows || builder.Plan is BodyPlan.Fish or BodyPlan.Whale or BodyPlan.Eel) || builder.Species.Disc.Sweep != 0)
        {
            return drawn;
        }

        double lacks = PortableMath.Pow(Math.Max(1, (rows ? LeastRowing : LeastDriven) / LengthOf(StanceSampler.ShapeOf(builder))), builder.Fitting);
        return drawn with { Tail = Math.Max(drawn.Tail, Math.Min(LongestDriven, drawn.Tail * lacks)) };
    }

    /// <summary>The posture with a fan of feathers that falls away from the rump, for level with the eye behind it a fan is a pair of lips, with an abdomen that does not turn down at its end, and with a bare tail that falls from the croup and bends out again: a level one points at who is behind it, and is a peg.</summary>
    public static BodyPosture Lower(CreatureBuilder builder)
    {
        builder.Posture = Fallen(builder);
        bool behind = builder.Kind != LocomotionKind.Swimming && builder.Plan is not (BodyPlan.Legless or BodyPlan.ManyLegged) && builder.Species.Class != AnimalClass.Arthropod && builder.Species.Disc.Sweep == 0;
        if (!behind || builder.Fitting == 0 || !IsBareEnd(builder))
        {
            return builder.Posture;
        }

        // Its end turns down, and its root up by half of that, so that the whole of it falls as before.
        double lacks = builder.Fitting * Math.Max(0, Scalar.Radians(TipFallDegrees) - Fall(builder, LastThird));
        return builder.Posture with { Tail = builder.Posture.Tail - (0.5 * lacks), TailBend = builder.Posture.TailBend + (lacks / BodyGrid.TailBones) };
    }

    private static BodyPosture Fallen(CreatureBuilder builder)
    {
        BodyPosture drawn = builder.Posture;
        if (builder.Fitting == 0 && !(builder.Kind == LocomotionKind.Walking && builder.Tail.Style == TailStyle.Feathers))
        {
            return drawn;
        }

        if (HasAbdomen(builder))
        {
            double down = Fall(builder);
            double excess = Math.Max(0, down - Scalar.Radians(AbdomenDegrees));
            double end = Math.Min(excess, Scalar.Radians(StraightenedDegrees));
            double lack = Math.Max(0, Scalar.Radians(LeastAbdomenDegrees) - down);
            return drawn with { Tail = drawn.Tail + (builder.Fitting * (lack - excess)), TailBend = drawn.TailBend - (builder.Fitting * end / BodyGrid.TailBones) };
        }

        if (builder.Tail.Style == TailStyle.Prehensile)
        {
            double rolled = Scalar.Radians(PlanTraits.IsAboveLegs(builder.Plan) ? RolledFallDegrees : RolledFallOnOthers);
            builder.Posture = drawn with { Tail = Scalar.Lerp(drawn.Tail, rolled, builder.Fitting) };
            double lacks = Math.Max(0, Scalar.Radians(RolledLeastFall) - Fall(builder));
            return builder.Posture with { Tail = builder.Posture.Tail + (builder.Fitting * lacks) };
        }

        if (builder.Tail.Style == TailStyle.Stinger && builder.Kind != LocomotionKind.Swimming)
        {
            return drawn with { Tail = drawn.Tail - (builder.Fitting * Scalar.Radians(StingDegrees)) };
        }

        bool fan = builder.Tail.Style == TailStyle.Feathers;
        bool balances = builder.Plan == BodyPlan.Theropod && builder.Tail.Style is TailStyle.Plain or TailStyle.Saurian;
        if (builder.Kind == LocomotionKind.Flying && fan)
        {
            return drawn with { Tail = drawn.Tail + (builder.Fitting * Math.Max(0, Scalar.Radians(FlownFallDegrees) - Fall(builder))) };
        }

        bool flown = builder.Plan == BodyPlan.Flapping && builder.Species.Class != AnimalClass.Arthropod && IsBareEnd(builder);
        bool trails = builder.Kind == LocomotionKind.Walking && builder.Plan == BodyPlan.Sprawling && builder.Species.Disc.Sweep == 0 && (IsBareEnd(builder) || IsWeighted(builder));
        if (trails)
        {
            double least = Scalar.Radians(IsWeighted(builder) ? WeightedDegrees : TrailingDegrees);
            return drawn with { Tail = drawn.Tail + (builder.Fitting * Math.Max(0, least - Fall(builder))) };
        }

        if (!flown && (builder.Kind != LocomotionKind.Walking || !(fan || balances || IsBare(builder) || (PlanTraits.IsAboveLegs(builder.Plan) && IsWeighted(builder)))))
        {
            return drawn;
        }

        double fall = Fall(builder);
        if (fan && fall < -Scalar.Radians(RaisedDegrees))
        {
            return drawn;
        }

        if (fan)
        {
            double least = PlanTraits.IsAboveLegs(builder.Plan) ? Scalar.Lerp(FallDegrees, FallOnFourLegs, builder.Fitting) : FallDegrees;
            return drawn with { Tail = drawn.Tail + Math.Max(0, Scalar.Radians(least) - fall) };
        }

        double hung = Scalar.Radians(balances ? BalancingDegrees : flown ? FlownDegrees : builder.Plan == BodyPlan.Upright ? UprightDegrees : HungDegrees);
        double tip = builder.Fitting * Scalar.Radians(TipDegrees) * hung / Scalar.Radians(HungDegrees);
        double lower = builder.Fitting * Math.Max(0, hung - fall);
        return drawn with { Tail = drawn.Tail + lower + (0.5 * tip), TailBend = drawn.TailBend - (tip / BodyGrid.TailBones) };
    }

    /// <summary>Lets the tail of a swimmer with flukes or without a fin fall a little: edge on flukes are a bar before the rump, and a level tail is a ring on it.</summary>
    public static void Sink(CreatureBuilder builder)
    {
        if (builder.Tail.Style is TailStyle.Fluke or TailStyle.Plain && builder.Species.Disc.Sweep == 0)
        {
            double lacks = builder.Fitting * Math.Max(0, Scalar.Radians(builder.Tail.Style == TailStyle.Plain && builder.Plan == BodyPlan.Flipper ? RowingDegrees + builder.Stream("fall of rower").Uniform(-RowersDiffer, RowersDiffer) : FlukeDegrees) - Fall(builder));
            builder.Posture = builder.Posture with { Tail = builder.Posture.Tail + lacks };
            builder.Drawn = builder.Drawn with { Tail = builder.Drawn.Tail + lacks };
            Straighten(builder);
        }
    }

    /// <summary>Bends a tail until its fluke lies nearly level, and carries it so that it comes down no farther for it.</summary>
    private static void Straighten(CreatureBuilder builder)
    {
        double own = builder.Stream("fluke").Uniform(-FlukesDiffer, FlukesDiffer);
        for (int round = 0; round < Rounds && builder.Tail.Style == TailStyle.Fluke; round++)
        {
            double rise = builder.Fitting * Math.Max(0, Fall(builder) - Scalar.Radians(SteepestStalk + own));
            builder.Posture = builder.Posture with { Tail = builder.Posture.Tail - rise };
            BodyShape shape = StanceSampler.ShapeOf(builder);
            int first = StationRing.TailThird;
            while (first < StationRing.TailTwoThirds && shape.Arc[LastOfTail] - shape.Arc[first] > TailShaper.LongestFluke * builder.Tail.Size)
            {
                first++;
            }

            double fluke = PortableMath.Atan2(shape.Y[first] - shape.Y[LastOfTail], shape.Z[first] - shape.Z[LastOfTail]);
            double bend = builder.Fitting * (Scalar.Clamp(fluke, Scalar.Radians(FlattestFluke + own), Scalar.Radians(SteepestFluke + own)) - fluke) / (BendAtFluke * BodyGrid.TailBones);
            builder.Posture = builder.Posture with { TailBend = builder.Posture.TailBend + bend };
            builder.Drawn = builder.Drawn with { Tail = builder.Drawn.Tail - rise, TailBend = builder.Drawn.TailBend + bend };
        }
    }

    /// <summary>Length of the tail against the trunk.</summary>
    private static double LengthOf(BodyShape shape) =>
        (shape.Arc[LastOfTail] - shape.Arc[StationRing.TorsoLast]) / (shape.Arc[StationRing.TorsoLast] - shape.Arc[StationRing.TrunkFirst]);

    /// <summary>How far the tail comes down from the rump, or from another ring, radians.</summary>
    private static double Fall(CreatureBuilder builder, int from = StationRing.TorsoLast)
    {
        BodyShape shape = StanceSampler.ShapeOf(builder);
        return PortableMath.Atan2(shape.Y[from] - shape.Y[LastOfTail], shape.Z[from] - shape.Z[LastOfTail]);
    }

    /// <summary>Whether the body ends in an insect's abdomen.</summary>
    private static bool HasAbdomen(CreatureBuilder builder) =>
        builder.Species.Class == AnimalClass.Arthropod && builder.Tail.Style == TailStyle.Plain && builder.Plan is BodyPlan.Buzzing or BodyPlan.Hexapod or BodyPlan.Flapping;

    /// <summary>Whether a tail behind legs under the body is bare, or one behind an upright body.</summary>
    private static bool IsBare(CreatureBuilder builder) => (PlanTraits.IsAboveLegs(builder.Plan) || builder.Plan == BodyPlan.Upright) && IsBareEnd(builder);

    /// <summary>Whether a tail is neither rolled up nor armed, and wears no hair.</summary>
    private static bool IsBareEnd(CreatureBuilder builder) =>
        !IsHaired(builder) && builder.Tail.Style is TailStyle.Plain or TailStyle.Saurian or TailStyle.Whip or TailStyle.Paddle;

    /// <summary>Whether a tail ends in a tuft or a club.</summary>
    private static bool IsWeighted(CreatureBuilder builder) => builder.Tail.Style == TailStyle.Club || IsHaired(builder);

    /// <summary>Whether a tail wears the hair of the parent that gives it.</summary>
    private static bool IsHaired(CreatureBuilder builder) =>
        builder.Parents.Tail.TailHair is not null && builder.Tail.Style == TailStyle.Plain
            && (builder.Parents.Skin.Cover == SkinCover.Fur || builder.Parents.Skin == builder.Parents.Tail);

    /// <summary>The slices with a point at the end of a bird's tail that wears no feathers, whose tables are made for a fan and end like a sawn log without one, of an abdomen, and of a swimmer's, whose fin comes later.</summary>
    public static ValueList<LatticeSlice> Point(CreatureBuilder builder, ValueList<LatticeSlice> drawn)
    {
        bool swims = builder.Kind == LocomotionKind.Swimming && builder.Species.Disc.Sweep == 0;
        bool insect = HasAbdomen(builder);
        bool bird = builder.Parents.Tail.Class == AnimalClass.Bird && builder.Tail.Style == TailStyle.Plain;
        if (!swims && !insect && !bird)
        {
            return drawn;
        }

        LatticeSlice[] slices = drawn.ToArray();
        int first = slices.Length - featherless.Length;
        for (int i = first; i < slices.Length; i++)
        {
            double end = (swims ? finless : insect ? abdomen : featherless)[i - first] * (swims && bird ? featherless[i - first] : 1);
            slices[i] = Thinner(slices[i], Scalar.Lerp(1, end, builder.Fitting));
        }

        return new ValueList<LatticeSlice>(slices);
    }

    /// <summary>The slices with a tail as the tables give it that runs out: what is left of its thickness at its end is a finger, a peg or a ball for who is behind it.</summary>
    public static ValueList<LatticeSlice> RunOut(CreatureBuilder builder)
    {
        if (builder.Tail.Style != TailStyle.Plain)
        {
            return builder.Slices;
        }

        LatticeSlice[] slices = builder.Slices.ToArray();
        BodyShape shape = StanceSampler.ShapeOf(builder);
        double largest = Largest(shape, FirstOfTail, LastOfTail);
        RandomStream random = builder.Stream("tail end");
        double end = Math.Min(1, random.Uniform(largestEnd.Min, largestEnd.Max) * largest / Largest(shape, StationRing.TailTwoThirds, StationRing.TailTwoThirds));
        double tip = Math.Min(1, LargestTip * largest / Largest(shape, LastOfTail, LastOfTail));
        int last = slices.Length - 1;
        slices[last - 1] = Thinner(slices[last - 1], PortableMath.Pow(end, BeforeEnd * builder.Fitting));
        slices[last] = Thinner(slices[last], PortableMath.Pow(Math.Min(tip, PortableMath.Pow(end, AtEnd)), builder.Fitting));
        return new ValueList<LatticeSlice>(slices);
    }

    private static LatticeSlice Thinner(LatticeSlice slice, double factor) =>
        slice with { Width = Math.Max(CommonRanges.Factor.Minimum, factor * slice.Width), Height = Math.Max(CommonRanges.Factor.Minimum, factor * slice.Height) };

    /// <summary>Whether the tail of one on two or four legs under its body hangs so steeply that it is seen between them from the front, or that of a flier like one leg more.</summary>
    public static bool HangsBetweenLegs(CreatureBuilder builder)
    {
        const int End = BodyGrid.Rings - 1;
        BodyShape s = builder.Shape;
        bool stands = PlanTraits.IsAboveLegs(builder.Plan) || (builder.Plan == BodyPlan.Upright && builder.Parents.Legs.Legs is null);
        double down = s.Y[StationRing.TorsoLast] - s.Y[End];
        double back = s.Z[StationRing.TorsoLast] - s.Z[End];
        bool fleshed = builder.Species.Class != AnimalClass.Bird || (builder.Fitting > 0 && builder.Parents.Tail.Class != AnimalClass.Bird);
        bool balances = builder.Plan == BodyPlan.Theropod && fleshed && builder.Tail.Style != TailStyle.Feathers;
        if (builder.Plan is BodyPlan.Flapping or BodyPlan.Buzzing && builder.Species.Class != AnimalClass.Arthropod)
        {
            return builder.Fitting > 0 && builder.Tail.Style != TailStyle.Feathers && down > SteepestFlown * back;
        }

        return (stands || balances) && down > (balances ? SteepestBalanced : builder.Plan == BodyPlan.Upright ? SteepestOfUpright : SteepestTail) * back && s.Y[End] < 0.75 * s.Y[StationRing.TorsoLast];
    }

    /// <summary>Radius of the largest section, metres.</summary>
    private static double Largest(BodyShape shape, int first, int last)
    {
        double size = 0;
        for (int ring = first; ring <= last; ring++)
        {
            size = Math.Max(size, Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring])));
        }

        return size;
    }
}
