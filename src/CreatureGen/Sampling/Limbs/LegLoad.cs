using System;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>How thick legs are for what they carry: those of a species are made for its own trunk, and a stouter one stands on them like a log on wires.</summary>
internal static class LegLoad
{
    // Most that a leg gets thicker by below its thigh: of an insect's, whose femur swells to twice its coxa as a beetle's does, and of those with folded knees under a body, whose shank would cross the thigh.
    private const double MaxOfJointed = 2.65;
    private const double MaxOfFolded = 1.2;

    /// <summary>Thickness that a bird's trunk asks for, relative to others of its size: much of it is feathers.</summary>
    private const double Feathery = 0.78;

    /// <summary>Factor on the radii below the thigh with which the shank of a standing leg looks as if it carried its share of the trunk.</summary>
    /// <param name="builder">The creature.</param>
    /// <param name="style">What its legs are like without it.</param>
    /// <param name="leg">The leg.</param>
    /// <param name="pairs">Pairs of legs that carry the trunk.</param>
    public static double Thicker(CreatureBuilder builder, LegStyle style, LegPlacement leg, int pairs)
    {
        LegKind kind = LegKinds.Of(leg.Site.Archetype);
        double wanted = kind.Build.CarryingShank * (builder.Species.Class == AnimalClass.Bird ? Feathery : 1);
        double share = PortableMath.Cbrt(StanceSampler.Volume(builder.Shape) / (2 * pairs));
        double shank = kind.Outline.ShankRadius() * leg.RootRadius * style.Stoutness * style.Slimness;
        return Scalar.Lerp(1, Scalar.Clamp(wanted * share / shank, 1, kind.Outline.Jointed ? MaxOfJointed : MaxOfFolded), builder.Fitting);
    }
}
