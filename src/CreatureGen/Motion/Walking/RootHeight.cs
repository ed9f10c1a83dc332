using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Motion.Walking.Trunk;

namespace CreatureGen.Motion.Walking;

/// <summary>
/// Keeps the root on the ground: up and down a slope as it goes, and the trunk with it, and after what else that ground does. On uneven ground that is the ground under the hips where they will be in a moment, wherever feet stand:
/// up and down stairs these are set from tread to tread, and the root was up to .42 of a leg off.
/// </summary>
internal struct RootHeight
{
    /// <summary>How quickly the root follows the ground under the body, per second, and besides for each leg length that it goes.</summary>
    private const float Rate = 6f;
    private const float RateOfWay = 1.3f;

    /// <summary>The same on uneven ground, which it foresees: no quicker, for every tread is a step for it.</summary>
    private const float UnevenRate = 4.5f;
    private const float UnevenRateOfWay = 1f;

    /// <summary>How far the root is behind that ground at most, leg lengths.</summary>
    private const float MaxLag = 0.25f;

    /// <summary>How far the ground under the hips may be off that under the feet, leg lengths: who stands on the edge of a pit is not in it.</summary>
    private const float MostOff = 0.35f;

    /// <summary>How far above and below the root that ground is felt, leg lengths: as far as feet find footing.</summary>
    private const float Range = 0.8f;

    private ExponentialDecay decay;
    private float rise;
    private float under;
    private bool felt;

    /// <summary>Forgets what it felt: the creature has been put somewhere else.</summary>
    public void Reset() => (rise, felt) = (0f, false);

    /// <summary>Brings the root up or down.</summary>
    /// <param name="placement">Where it is.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="placer">Knows the ground under the feet, and is told.</param>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="h">Seconds.</param>
    /// <param name="up">Unit, world space.</param>
    public RootPlace Follow(in RootPlace placement, float legLength, BodyPlacer placer, float speed, float h, Vector3 up)
    {
        float climb = placer.Climb * speed * h;
        float height = placer.GroundUnderHips;
        if (felt)
        {
            // Seen from where the slope under the feet goes on to by then.
            float pace = UnevenPace(speed, legLength);
            float there = height + (placer.Climb * speed * Foresight(pace));
            float most = MostOff * legLength;
            height = 0f;
            CriticallyDampedSpring.Advance(ref height, ref rise, there + Scalar.Clamp(under - there, -most, most), pace, h);
            under -= height;
            height -= climb;
        }
        else
        {
            height = Part(height, legLength, speed, h);
        }

        if (height == 0f && climb == 0f)
        {
            return placement;
        }

        placer.RootRaised(height);
        return new RootPlace(placement.Position + (up * ((height + climb) * placement.Scale)), placement.Rotation, placement.Scale);
    }

    /// <summary>Feels the ground where the hips will be by the time at which the root has gone there, as often as it is decided how to go on.</summary>
    /// <param name="placement">Where the root is.</param>
    /// <param name="body">Whose.</param>
    /// <param name="velocity">How it goes.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">The ground; what is level everywhere is not felt.</param>
    public void Feel(in RootPlace placement, LeggedBody body, in RootVelocity velocity, Vector3 up, IGround ground)
    {
        bool before = felt;
        felt = false;
        float reach = Range * body.LegLength;
        if (ground is IPlaneGround plane && plane.Normal == up)
        {
            return;
        }

        var range = new GroundRange(placement, up, ground, reach, reach);
        Vector3 way = velocity.Predict(Foresight(UnevenPace(velocity.Speed, body.LegLength)), out float yaw);
        Quaternion turn = AxisRotation.Yaw(yaw);
        if (range.Has(way + Rotation.Rotate(turn, body.HindHips), out float height))
        {
            under = height;
            felt = true;
            if (body.Rows > 1)
            {
                felt = range.Has(way + Rotation.Rotate(turn, body.ForeHips), out height);
                under = 0.5f * (under + height);
            }
        }

        rise = before ? rise : 0f;
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

    private static float UnevenPace(float speed, float legLength) => UnevenRate + (UnevenRateOfWay * Math.Abs(speed) / legLength);

    /// <summary>Seconds that a spring takes to go on.</summary>
    private static float Foresight(float pace) => 2f / pace;
}
