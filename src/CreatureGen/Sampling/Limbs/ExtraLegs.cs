using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Third and fourth pairs of legs between those of what goes on four: under mammals and beside reptiles.</summary>
internal static class ExtraLegs
{
    /// <summary>Most pairs of legs under a body that has room for them.</summary>
    public const int Max = 4;

    /// <summary>Probability at full strangeness.</summary>
    private const double Chance = 0.3;

    /// <summary>Share of eight legs among these.</summary>
    private const double Eight = 0.3;

    /// <summary>How much longer the middle of the torso is for each further pair.</summary>
    private const double Room = 0.36;

    /// <summary>Thickness of the pairs between relative to the first: as thick as that they stand on one another.</summary>
    private const double Thinner = 0.8;

    /// <summary>Shortest of eight legs, in lengths of the body.</summary>
    private const double EightLegged = 0.24;

    /// <summary>Whether a plan may stand on more than two pairs.</summary>
    public static bool Suits(BodyPlan plan) => plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Sprawling;

    /// <summary>How many pairs a creature is to stand on beyond two.</summary>
    public static int PairsOf(CreatureBuilder builder) => Math.Max(0, Math.Min(Wanted(builder), builder.MaxLegPairs - 2));

    /// <summary>Factor on the length of the middle of the torso.</summary>
    public static double LengthOf(CreatureBuilder builder) => 1 + (Room * Wanted(builder));

    /// <summary>Pairs beyond two that are drawn or asked for at least, whether all of them may be or not.</summary>
    private static int Wanted(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("extra legs");
        bool extra = random.Chance(Chance * builder.Strangeness);
        int pairs = 2 + (random.Chance(Eight) ? 2 : 1);
        bool fits = builder.Kind == LocomotionKind.Walking && Suits(builder.Plan) && builder.Parents.Legs.Legs is null && builder.Parents.Legs.Bird is null;
        return fits ? Math.Min(Math.Max(builder.MinLegPairs, extra ? pairs : 2), Max) - 2 : 0;
    }

    /// <summary>The places of a set with further pairs between its first and its last.</summary>
    public static SocketSet Between(SocketSet set, int extra)
    {
        LimbSocket front = set.Legs[0];
        LimbSocket rear = set.Legs[set.Legs.Count - 1];
        int first = extra > 1 ? front.Ring - 1 : front.Ring;
        int last = extra > 1 ? rear.Ring + 1 : rear.Ring;
        var legs = new List<LimbSocket> { front with { Ring = first } };
        for (int k = 1; k <= extra; k++)
        {
            double fraction = k / (extra + 1.0);
            legs.Add(front with { Ring = (int)Math.Round(first + (fraction * (last - first)), MidpointRounding.ToEven), Girth = Thinner * front.Girth, Azimuth = front.Azimuth * (1 - (2 * fraction)) });
        }

        legs.Add(rear with { Ring = last });
        // Eight legs find room for their strides under a body that is carried low.
        StanceLimits stance = extra > 1 ? set.Stance with { MinimumLength = Math.Min(set.Stance.MinimumLength, EightLegged) } : set.Stance;
        return set with { Legs = legs, MinimumPairs = legs.Count, Arms = null, Stance = stance };
    }
}
