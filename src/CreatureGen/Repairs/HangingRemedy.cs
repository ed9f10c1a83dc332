using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Repairs;

/// <summary>Lets the legs of fliers and swimmers hang: what moves by wings or fins need not stand on feet that do not carry it.</summary>
internal static class HangingRemedy
{
    /// <summary>Changes the blueprint. False if it walks, or none of its legs stands.</summary>
    public static bool Apply(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        return b.Kind != LocomotionKind.Walking && log.Change(b with { Legs = b.Legs.Each(leg => leg with { Stance = LegStance.Hanging }) }, "its feet could not be brought under its centre of mass");
    }
}
