using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Hips of strange creatures in proportion to their trunks: their height follows from the trunk's length, and a long thin trunk would stand on legs that are thicker than itself.</summary>
internal static class HipFit
{
    // Tallest hips in depths of the trunk: on two legs, on toes, on hooves and on whole soles. Of animals only cranes, giraffes and slender runners stand taller.
    private const double OnTwoLegs = 2.2;
    private const double OnToes = 2;
    private const double OnHooves = 2.3;
    private const double OnSoles = 1.7;

    /// <summary>The same on the legs of a bird: thin ones look longer than they are, and under a body of another they are stilts with a square gap between them.</summary>
    private const double OnBirdLegs = 2.3;

    /// <summary>Factor on the height at which a trunk is carried, at most 1; animals keep theirs.</summary>
    /// <param name="builder">The creature.</param>
    /// <param name="trunk">Its trunk.</param>
    /// <param name="hip">The height of its hips without this, metres.</param>
    public static double Lower(CreatureBuilder builder, TrunkOutline trunk, double hip)
    {
        double tallest = builder.Plan switch
        {
            BodyPlan.Theropod => builder.Parents.Legs.Bird is null ? OnTwoLegs : OnBirdLegs,
            BodyPlan.Digitigrade or BodyPlan.Centaur => OnToes,
            BodyPlan.Unguligrade => OnHooves,
            BodyPlan.Plantigrade or BodyPlan.Columnar => OnSoles,
            _ => double.PositiveInfinity,
        };
        return hip > tallest * trunk.Depth ? PortableMath.Pow(tallest * trunk.Depth / hip, builder.Fitting) : 1;
    }
}
