using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>How the chest joins in as the head looks at something: it turns some of the way, after the head, as far as feet that stand allow.</summary>
internal struct ChestLook
{
    /// <summary>How quickly the chest turns, per second: slower than any head.</summary>
    private const float Rate = 3f;

    /// <summary>Yaw up to which the head turns alone, radians, and the part of what is beyond that is the chest's.</summary>
    private const float HeadAlone = 0.3f;
    private const float Fraction = 0.35f;

    /// <summary>Most that it turns, radians: on two legs, whose chest carries none of them, on legs under the body, and on legs out to the side.</summary>
    private const float MaxOfBipeds = 0.35f;
    private const float Max = 0.16f;
    private const float MaxOfLateral = 0.10f;

    /// <summary>Radians, and radians per second, below which it is straight again.</summary>
    private const double Straight = 1e-5;

    private CriticallyDampedSpring spring;

    /// <summary>Yaw of the chest, radians.</summary>
    public readonly float Angle => (float)spring.Value;

    /// <summary>Follows what is looked at.</summary>
    /// <param name="body">Whose chest.</param>
    /// <param name="yaw">Of what is looked at, seen from the root, radians; 0 for nothing.</param>
    /// <param name="dt">Seconds.</param>
    public void Follow(LeggedBody body, float yaw, float dt)
    {
        float max = body.IsBiped ? MaxOfBipeds : body.Legs[0].Lateral ? MaxOfLateral : Max;
        if (yaw == 0f && Math.Abs(spring.Value) < Straight && Math.Abs(spring.Rate) < Straight)
        {
            spring = default;
            return;
        }

        float beyond = yaw - Scalar.Clamp(yaw, -HeadAlone, HeadAlone);
        spring.Step(Scalar.Clamp(Fraction * beyond, -max, max), Rate, dt);
    }
}
