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
        if (b.Kind == LocomotionKind.Walking)
        {
            return false;
        }

        ValueList<LegBlueprint> legs = b.Legs;
        for (int i = 0; i < legs.Count; i++)
        {
            legs = legs.With(i, legs[i] with { Stance = LegStance.Hanging });
        }

        return log.Change(b with { Legs = legs }, "its feet could not be brought under its centre of mass");
    }
}
