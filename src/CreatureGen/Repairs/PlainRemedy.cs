using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Inspection;

namespace CreatureGen.Repairs;

/// <summary>The last resort: takes a shape that is too extreme to be cured part by part some of the way back to plain proportions, a level spine and legs as they are built for most.</summary>
internal static class PlainRemedy
{
    /// <summary>Part of the way that is taken at a time.</summary>
    private const double Fraction = 0.35;

    /// <summary>Changes the blueprint. False if it is plain already.</summary>
    public static bool Apply(RepairLog log, InvariantViolation violation)
    {
        CreatureBlueprint b = log.Blueprint;
        BodyBlueprint body = b.Body;
        double torso = b.Plan == BodyPlan.Upright ? body.Posture.Torso : 0;
        CreatureBlueprint plain = b with
        {
            Body = body with
            {
                Proportions = BodyFields.Proportions.Neutral,
                Slices = BodyFields.Body.Neutral.Slices,
                Posture = BodyFields.Posture.Neutral with { Torso = torso },
                Annuli = body.Annuli with { Depth = 0 },
                Disc = BodyFields.Disc.Neutral,
            },
            Head = b.Head with { Bumps = b.Head.Bumps.Each(bump => bump with { Amount = 0 }) },
            Legs = b.Legs.Each(leg => leg with { Reach = leg.Length, Azimuth = 0, Shear = 0, Slimness = 1, Stoutness = 1, FootSize = 1, KneeRise = 1, Thickness = 0.15 * leg.Length }),
        };
        return log.Change(FieldBlend.Between(b, plain, Fraction), "the shape was too extreme to keep its promises (" + violation.Invariant + ")");
    }
}
