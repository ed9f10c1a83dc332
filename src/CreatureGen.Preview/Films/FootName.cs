using System;
using CreatureGen.Anatomy;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Films;

/// <summary>What a foot is called in a film strip, and its colour there.</summary>
internal static class FootName
{
    // Left cold, right warm; pairs from the front.
    private static readonly Pixel[] lefts = [new(38, 112, 201), new(24, 150, 140), new(92, 84, 200), new(58, 140, 66)];
    private static readonly Pixel[] rights = [new(208, 66, 52), new(214, 134, 20), new(190, 60, 140), new(146, 106, 50)];

    /// <summary>Left and right of the one pair, <c>LF RF LH RH</c> of two pairs, numbered from the front of more.</summary>
    public static string Of(LeggedBody body, int foot)
    {
        LegRig leg = body.Legs[foot];
        string side = leg.Side == Side.Right ? "R" : "L";
        return body.Rows switch
        {
            1 => side,
            2 => side + (leg.Row == 1 ? "F" : "H"),
            _ => FormattableString.Invariant($"{side}{body.Rows - leg.Row}"),
        };
    }

    /// <summary>Its colour.</summary>
    public static Pixel Colour(LeggedBody body, int foot)
    {
        LegRig leg = body.Legs[foot];
        int pair = (body.Rows - 1 - leg.Row) % lefts.Length;
        return leg.Side == Side.Right ? rights[pair] : lefts[pair];
    }
}
