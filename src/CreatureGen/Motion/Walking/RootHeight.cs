using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Trunk;

namespace CreatureGen.Motion.Walking;

/// <summary>Keeps the root on the ground under the feet: up and down a slope as it goes, and the trunk with it, and after what else that ground does.</summary>
internal struct RootHeight
{
    /// <summary>How quickly the root follows the ground under the body, per second, and besides for each leg length that it goes.</summary>
    private const float Rate = 6f;
    private const float RateOfWay = 1.3f;

    /// <summary>How far the root is behind that ground at most, leg lengths.</summary>
    private const float MaxLag = 0.25f;

    private ExponentialDecay decay;

    /// <summary>Brings the root up or down.</summary>
    /// <param name="placement">Where it is.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="placer">Knows the ground under the feet, and is told.</param>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="h">Seconds.</param>
    /// <param name="up">Unit, world space.</param>
    public RootPlace Follow(in RootPlace placement, float legLength, BodyPlacer placer, float speed, float h, Vector3 up)
    {
        float height = Part(placer.GroundUnderHips, legLength, speed, h);
        float climb = placer.Climb * speed * h;
        if (height == 0f && climb == 0f)
        {
            return placement;
        }

        placer.RootRaised(height);
        return new RootPlace(placement.Position + (up * ((height + climb) * placement.Scale)), placement.Rotation, placement.Scale);
    }

    /// <summary>How far the root goes of its way to the ground.</summary>
    /// <param name="away">The way, metres.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="h">Seconds.</param>
    public float Part(float away, float legLength, float speed, float h)
    {
        float max = MaxLag * legLength;
        return (away * decay.Fraction((Rate + (RateOfWay * Math.Abs(speed) / legLength)) * h)) + (away - Scalar.Clamp(away, -max, max));
    }
}
