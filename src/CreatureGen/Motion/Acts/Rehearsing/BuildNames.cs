using System;
using System.Linq;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Builds and parts in words.</summary>
internal static class BuildNames
{
    /// <summary>A build.</summary>
    public static string Of(BodyBuild build) => build switch
    {
        BodyBuild.Pawed => "on paws",
        BodyBuild.Hoofed => "on hooves",
        BodyBuild.Columnar => "on pillars",
        BodyBuild.Sprawling => "on legs out to its sides",
        BodyBuild.ManyLegged => "on many legs",
        BodyBuild.TwoLegged => "on two legs",
        BodyBuild.Upright => "upright on two legs",
        BodyBuild.Legless => "on its belly",
        BodyBuild.Swimming => "in water",
        BodyBuild.Airborne => "always in the air",
        _ => throw new ArgumentOutOfRangeException(nameof(build), build, "expected one build"),
    };

    /// <summary>Parts that are missing.</summary>
    public static string Of(ActNeeds parts)
    {
        (ActNeeds Part, string Name)[] names =
        {
            (ActNeeds.Head, "head"),
            (ActNeeds.Jaw, "jaw that opens"),
            (ActNeeds.Horns, "horns, antlers or tusks"),
            (ActNeeds.Legs, "legs to stand on"),
            (ActNeeds.FourLegs, "second pair of legs"),
            (ActNeeds.LongTail, "tail half as long as its body"),
            (ActNeeds.Tail, "tail"),
            (ActNeeds.Arms, "arms"),
            (ActNeeds.Lids, "lids that shut"),
            (ActNeeds.Sting, "sting"),
            (ActNeeds.Abdomen, "abdomen"),
            (ActNeeds.Flanks, "flanks to lie on above its legs"),
            (ActNeeds.Back, "back to lie on between legs out to the sides"),
            (ActNeeds.BareFlanks, "flanks free of wings"),
            (ActNeeds.Front, "front to raise before three pairs of legs that stand"),
        };
        return string.Join(" and no ", names.Where(name => (parts & name.Part) != 0).Select(name => name.Name));
    }
}
