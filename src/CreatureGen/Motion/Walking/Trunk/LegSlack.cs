using System;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>How much farther legs reach than they stand: so much higher a body can be as they push off. Of the legs of a girdle the least.</summary>
/// <param name="Hind">Of the hind legs, metres.</param>
/// <param name="Fore">Of the fore legs; where there are none, of the hind legs.</param>
internal readonly record struct LegSlack(float Hind, float Fore)
{
    /// <summary>That of a body.</summary>
    public static LegSlack Of(LeggedBody body)
    {
        float hind = float.PositiveInfinity;
        float fore = float.PositiveInfinity;
        foreach (LegRig leg in body.Legs)
        {
            float slack = Math.Max((1f - leg.RestStretch) * leg.Reach, 0f);
            hind = leg.IsHind(body.Rows) ? Math.Min(hind, slack) : hind;
            fore = leg.IsHind(body.Rows) ? fore : Math.Min(fore, slack);
        }

        return new LegSlack(hind, body.Rows == 1 ? hind : fore);
    }
}
