using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Placement;

/// <summary>Places the wings and legs of a flier.</summary>
/// <remarks>Based on: A. Christo, "Procedural Creature Generation and Animation for Games" (MSc thesis, Bournemouth University, 2022), section 4.2.1. Creatures without legs are added.</remarks>
internal static class FlyingRules
{
    /// <summary>Most pairs of legs.</summary>
    public const int MaxPairs = 8;

    /// <summary>Ring of the anatomical place of flapping wings.</summary>
    public const int WingRing = 27;

    /// <summary>Where flapping wings grow: on a shoulder.</summary>
    public static SocketBlueprint WingSocket => SocketSizing.Centre(WingRing, WingSegment, WingRows, WingColumns);

    /// <summary>Where wings grow that only stand over a back: arms that carry nothing have no shoulder.</summary>
    public static SocketBlueprint RaisedWingSocket => SocketSizing.Centre(WingRing, WingSegment, RaisedRows, RaisedColumns);

    /// <summary>Fewest rings between the roots of two pairs of thin wings.</summary>
    public const double WingRingGap = 3;

    private const double WingSegment = 6;
    private const int WingRows = 4;
    private const int WingColumns = 4;
    private const int RaisedRows = 6;
    private const int RaisedColumns = 2;

    private static readonly ScaleRange uniformWing = new(0.85, 1.2);
    private static readonly ScaleRange thinWing = new(0.75, 1.3);

    /// <summary>Asks for 0 to 8 pairs of legs, clustered or not, all equally likely.</summary>
    public static FlyingLegs DrawLegs(RandomStream stream)
    {
        int pairs = stream.Integer(0, MaxPairs + 1);
        return new FlyingLegs(pairs, stream.Chance(0.5) ? LegArrangement.Clustered : LegArrangement.Spread);
    }

    /// <summary>
    /// Part of the size of a leg that is left when a creature has many: 1 / √pairs, so that all legs of a creature together have the same cross-section.
    /// </summary>
    public static double LegFactor(int pairs) => pairs <= 1 ? 1 : 1 / Math.Sqrt(pairs);

    /// <summary>Places the limbs of a flier.</summary>
    /// <param name="measure">Its torso.</param>
    /// <param name="motion">How its wings beat.</param>
    /// <param name="wingPairs">Pairs of thin wings, 1 or 2; flapping wings are always one pair.</param>
    /// <param name="legs">What legs it asks for.</param>
    /// <param name="anatomy">Where legs may grow.</param>
    /// <param name="occupied">Cells already taken; not changed.</param>
    /// <param name="seed">Decides; children "wings" and "legs".</param>
    /// <exception cref="ArgumentOutOfRangeException">A number of pairs is out of range.</exception>
    public static FlyingPlacement Place(
        SpineMeasure measure,
        WingMotion motion,
        int wingPairs,
        FlyingLegs legs,
        FlierLegAnatomy anatomy,
        SocketGrid occupied,
        Seed seed)
    {
        if (legs.Pairs < 0 || legs.Pairs > MaxPairs)
        {
            throw new ArgumentOutOfRangeException(nameof(legs), legs.Pairs, FormattableString.Invariant($"expected 0 to {MaxPairs} pairs of legs"));
        }

        if (wingPairs < 1 || wingPairs > (motion == WingMotion.Buzzing ? 2 : 1))
        {
            throw new ArgumentOutOfRangeException(nameof(wingPairs), wingPairs, "expected 1 pair of flapping wings, or 1 or 2 pairs of thin ones");
        }

        LegFitting.Check(anatomy.Size);
        SocketGrid grid = occupied.Copy();
        RandomStream wingStream = seed.Child("wings").Stream();
        List<WingPlacement> wings = motion == WingMotion.Buzzing ? Buzzing(measure, wingPairs, wingStream) : Flapping(measure, grid, wingStream);
        RandomStream legStream = seed.Child("legs").Stream();
        double spread = legStream.Uniform(0.9, 1.1);
        int firstBone = legStream.Integer(0, FrontHalf(measure));
        var placed = new List<LegPlacement>();
        double factor = LegFactor(legs.Pairs) * spread;
        for (int pairs = legs.Pairs; pairs > 0 && placed.Count == 0; pairs--)
        {
            // Fewer legs are larger: each number is tried with its own size, and the greatest that finds free bones for all is taken.
            factor = LegFactor(pairs) * spread;
            List<LegPlacement> candidates = Candidates(measure, anatomy, factor);
            List<LegPlacement> trial = legs.Arrangement == LegArrangement.Clustered
                ? Clustered(candidates, pairs, measure.Along(firstBone), grid.Copy())
                : Spread(candidates, pairs, grid.Copy());
            placed = trial.Count == pairs ? trial : placed;
        }

        placed.Sort((a, b) => a.Along.CompareTo(b.Along));
        return new FlyingPlacement(motion, wings, placed, factor);
    }

    /// <summary>Number of bones of the front half of the spine, from the head; at least 1.</summary>
    public static int FrontHalf(SpineMeasure measure) => Math.Max(1, measure.Bones.Count / 2);

    private static List<WingPlacement> Buzzing(SpineMeasure measure, int pairs, RandomStream stream)
    {
        var wings = new List<WingPlacement>();
        int bone = stream.Integer(0, FrontHalf(measure));
        wings.Add(new WingPlacement(bone, measure.Bones[bone].Ring, null, thinWing.DrawEach(stream)));
        if (pairs == 1)
        {
            return wings;
        }

        // The second pair sits on the nearest bone of the front half that leaves room for the roots of both, behind if possible.
        PartScale scale = thinWing.DrawEach(stream);
        int second = -1;
        for (int i = 0; i < FrontHalf(measure); i++)
        {
            double gap = Math.Abs(measure.Bones[i].Ring - measure.Bones[bone].Ring);
            if (gap >= WingRingGap && (second < 0 || gap <= Math.Abs(measure.Bones[second].Ring - measure.Bones[bone].Ring)))
            {
                second = i;
            }
        }

        if (second >= 0)
        {
            wings.Insert(second < bone ? 0 : 1, new WingPlacement(second, measure.Bones[second].Ring, null, scale));
        }

        return wings;
    }

    private static List<WingPlacement> Flapping(SpineMeasure measure, SocketGrid grid, RandomStream stream)
    {
        // The middle bone has one anatomical place for wings: the shoulders.
        var wings = new List<WingPlacement>();
        PartScale scale = uniformWing.DrawUniform(stream);
        SocketBlueprint socket = WingSocket;
        if (grid.TryReserve(socket, SocketBounds.Limb.Pad))
        {
            wings.Add(new WingPlacement(measure.BoneAt(WingRing), WingRing, socket, scale));
        }

        return wings;
    }

    /// <summary>The first pair at the place nearest to a bone, the others around it, the nearest free place first.</summary>
    private static List<LegPlacement> Clustered(List<LegPlacement> candidates, int pairs, double along, SocketGrid grid)
    {
        var placed = new List<LegPlacement>();
        double centre = NearestTo(candidates, along).Along;
        candidates.Sort((a, b) =>
        {
            int byDistance = Math.Abs(a.Along - centre).CompareTo(Math.Abs(b.Along - centre));
            return byDistance != 0 ? byDistance : a.Site.Ring.CompareTo(b.Site.Ring);
        });
        for (int i = 0; i < candidates.Count && placed.Count < pairs; i++)
        {
            TryAdd(candidates[i], placed, grid);
        }

        return placed;
    }

    /// <summary>Each pair in the middle of its equal share of the stretch that may carry legs, at the nearest place.</summary>
    private static List<LegPlacement> Spread(List<LegPlacement> candidates, int pairs, SocketGrid grid)
    {
        var placed = new List<LegPlacement>();
        double first = candidates[0].Along;
        double stretch = candidates[candidates.Count - 1].Along - first;
        bool fits = true;
        for (int k = 0; k < pairs && fits; k++)
        {
            fits = TryAdd(NearestTo(candidates, first + (stretch * (k + 0.5) / pairs)), placed, grid);
        }

        return placed;
    }

    /// <summary>A leg of its own length at each place: what carries the body is told later, by the rules for walkers.</summary>
    private static List<LegPlacement> Candidates(SpineMeasure measure, FlierLegAnatomy anatomy, double factor)
    {
        var candidates = new List<LegPlacement>();
        foreach (LimbSocket site in anatomy.Sockets)
        {
            candidates.Add(LegFitting.Hang(measure, site, anatomy.Size, anatomy.Length * measure.BodyLength * factor, factor));
        }

        return candidates;
    }

    private static LegPlacement NearestTo(List<LegPlacement> candidates, double along)
    {
        LegPlacement best = candidates[0];
        foreach (LegPlacement candidate in candidates)
        {
            if (Math.Abs(candidate.Along - along) < Math.Abs(best.Along - along))
            {
                best = candidate;
            }
        }

        return best;
    }

    private static bool TryAdd(LegPlacement leg, List<LegPlacement> placed, SocketGrid grid)
    {
        foreach (LegPlacement other in placed)
        {
            if (LegSweep.Crosses(leg, other))
            {
                return false;
            }
        }

        if (!grid.TryReserve(leg.Socket, leg.Site.Bounds.Pad))
        {
            return false;
        }

        placed.Add(leg);
        return true;
    }
}
