using System;
using CreatureGen.Anatomy;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>Ground under hind and fore feet, seen along the slope from the middle of where they belong: half way between their lowest and their mean. A heel that hangs over an edge counts as the ground below it: up stairs feet stand near edges, and bodies do not go as high as those.</summary>
/// <param name="Hind">Height under the hind feet above the root, metres.</param>
/// <param name="Fore">The same of the fore feet; where there are none, of the hind feet.</param>
/// <param name="Across">How much higher it is on the left than on the right, metres.</param>
internal readonly record struct GroundUnderFeet(float Hind, float Fore, float Across)
{
    /// <summary>That of a body at present.</summary>
    /// <param name="body">Gives the legs.</param>
    /// <param name="feet">Their places as last posed.</param>
    /// <param name="climb">Rise of the ground along the way.</param>
    public static GroundUnderFeet Of(LeggedBody body, ReadOnlySpan<Foot> feet, float climb)
    {
        float hindMin = float.MaxValue;
        float foreMin = float.MaxValue;
        float hindSum = 0f;
        float foreSum = 0f;
        float left = 0f;
        float right = 0f;
        int hindCount = 0;
        int leftCount = 0;
        for (int i = 0; i < feet.Length; i++)
        {
            LegRig leg = body.Legs[i];
            float y = feet[i].Path.Base.Y + feet[i].Below + (leg.Lateral ? feet[i].Path.Over : 0f) - (climb * (feet[i].Path.Base.Z - (leg.IsHind(body.Rows) ? body.Span.Rear : body.Span.Front)));
            if (leg.IsHind(body.Rows))
            {
                hindMin = Math.Min(hindMin, y);
                hindSum += y;
                hindCount++;
            }
            else
            {
                foreMin = Math.Min(foreMin, y);
                foreSum += y;
            }

            if (leg.Side == Side.Left)
            {
                left += y;
                leftCount++;
            }
            else
            {
                right += y;
            }
        }

        int foreCount = feet.Length - hindCount;
        float hind = 0.5f * (hindMin + (hindSum / hindCount));
        float fore = foreCount == 0 ? hind : 0.5f * (foreMin + (foreSum / foreCount));
        return new GroundUnderFeet(hind, fore, (left / Math.Max(leftCount, 1)) - (right / Math.Max(feet.Length - leftCount, 1)));
    }
}
