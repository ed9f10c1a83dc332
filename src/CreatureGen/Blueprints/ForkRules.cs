using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>Where a body may fork into two necks.</summary>
internal static class ForkRules
{
    /// <summary>The ring at which it forks where nothing is in the way.</summary>
    public const int Usual = StationRing.NeckBase;

    /// <summary>The foremost ring at which it may fork: in front of it too little neck is left.</summary>
    public const int Foremost = StationRing.TrunkFirst;

    /// <summary>The last ring in front of all limbs at which the body can fork; −1 for none.</summary>
    public static int RingOf(CreatureBlueprint blueprint)
    {
        int first = Usual + 1;
        foreach (LegBlueprint leg in blueprint.Legs)
        {
            first = Math.Min(first, leg.Socket.Ring);
        }

        foreach (WingBlueprint wing in blueprint.Wings)
        {
            first = Math.Min(first, wing.Socket.Ring);
        }

        foreach (FinBlueprint fin in blueprint.Fins)
        {
            first = Math.Min(first, fin.Socket.Ring);
        }

        return first - 1 >= Foremost ? first - 1 : -1;
    }
}
