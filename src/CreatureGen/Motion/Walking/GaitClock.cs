using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Gaits;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Trunk;

namespace CreatureGen.Motion.Walking;

/// <summary>
/// Where a creature is in its cycle, and the numbers of its gait at present. Gaits change by sliding their constants, never their poses: each lag by at most 0.30 cycle and the duty by at most 0.35
/// in a cycle, so that no leg's phase runs backwards; all else at 2 s⁻¹.
/// </summary>
internal sealed class GaitClock
{
    private const float LagPerCycle = 0.30f;
    private const float DutyPerCycle = 0.35f;
    private const float ShapeRate = 2f;

    /// <summary>Yaw of the body in one cycle on the spot, radians.</summary>
    private const float YawPerCycle = 0.45f;

    private readonly LeggedBody body;
    private readonly float[] lags;
    private readonly float quickest;
    private float frequencyRest;
    private ExponentialDecay shapeDecay;
    private Gait? measured;
    private float measuredFroude;
    private float measuredGravity;
    private float measuredSlope;
    private float measuredFrequency;
    private SlopeStance longest;
    private float slope;

    public GaitClock(LeggedBody body, Gait gait)
    {
        this.body = body;
        lags = new float[body.Legs.Length];
        quickest = GaitSet.QuickestOf(body.Mass);
        Gait = gait;
        Shape = GaitShape.Of(gait);
        Restart(gait, 0f, Lead.Left);
    }

    /// <summary>The gait at present, or the one being gone over to.</summary>
    public Gait Gait { get; private set; }

    /// <summary>Its numbers at present.</summary>
    public GaitShape Shape;

    /// <summary>Place in the cycle, 0..1.</summary>
    public double Phase { get; set; }

    /// <summary>Cycles per second.</summary>
    public float Frequency { get; private set; }

    /// <summary>Part of the cycle that a foot is down.</summary>
    public float Duty { get; private set; }

    /// <summary>The side that leads in canter and gallop.</summary>
    public Lead Lead { get; private set; }

    /// <summary>Lag of each leg's touchdown, 0..1.</summary>
    public ReadOnlySpan<float> Lags => lags;

    /// <summary>A leg's place in its own cycle, 0..1: stance up to the duty, then swing.</summary>
    public float LegPhase(int leg)
    {
        float p = (float)Phase - lags[leg];
        return p - (float)Math.Floor(p);
    }

    /// <summary>Takes a gait at once: only while all feet stand.</summary>
    public void Restart(Gait gait, float froude, Lead lead)
    {
        Gait = gait;
        Lead = lead;
        Shape = GaitShape.Of(gait);
        Duty = gait.Duty.At(froude);
        frequencyRest = 0f;
        for (int i = 0; i < lags.Length; i++)
        {
            lags[i] = WantedLag(i);
        }
    }

    /// <summary>Begins to go over to another gait.</summary>
    public void Change(Gait gait, float froude, float gravity, Lead lead)
    {
        frequencyRest += FrequencyOf(Gait, froude, gravity) - FrequencyOf(gait, froude, gravity);
        Gait = gait;
        Lead = lead;
    }

    /// <summary>Lets the numbers go on their way.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="froude">v²/(gℓ).</param>
    /// <param name="gravity">Metres per second squared.</param>
    /// <param name="turn">Radians per second.</param>
    /// <param name="pace">Speed, in slow walks, 0..1: what of a turn is done on the spot.</param>
    /// <param name="rise">Of the ground along the way: long strides are shorter uphill and downhill.</param>
    /// <param name="stride">Length of strides, a factor.</param>
    public void Slide(float dt, float froude, float gravity, float turn, float pace, float rise, float stride = 1f)
    {
        slope = rise;
        float fraction = shapeDecay.Fraction(ShapeRate * dt);
        Shape.Approach(Gait, fraction);
        frequencyRest -= frequencyRest * fraction;
        float spot = Math.Abs(turn) / YawPerCycle * (1f - (0.5f * pace));
        Frequency = Math.Max((FrequencyOf(Gait, froude, gravity) + frequencyRest) / stride, spot);
        float cycle = Frequency * dt;
        float duty = Gait.Duty.At(froude);
        Duty += Scalar.Clamp(duty - Duty, -DutyPerCycle * cycle, DutyPerCycle * cycle);
        float max = LagPerCycle * cycle;
        for (int i = 0; i < lags.Length; i++)
        {
            float d = WantedLag(i) - lags[i] + 0.5f;
            d -= (float)Math.Floor(d) + 0.5f;
            float lag = lags[i] + Scalar.Clamp(d, -max, max);
            lags[i] = lag - (float)Math.Floor(lag);
        }
    }

    /// <summary>The speed that a creature goes on a slope when it is asked for one: less where shorter strides would come quicker than its mass lets them.</summary>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="gravity">Metres per second squared.</param>
    public float OnSlope(float speed, float gravity)
    {
        float stance = longest.At(slope);
        if (stance >= longest.Level)
        {
            return speed;
        }

        float froude = speed * speed / (gravity * body.LegLength);
        float level = GaitSet.FrequencyOf(Gait, froude, body.LegLength, gravity, longest.Level);
        float here = GaitSet.FrequencyOf(Gait, froude, body.LegLength, gravity, stance);
        return speed * Math.Min(1f, Math.Max(quickest, level) / here);
    }

    /// <summary>Cycles per second of a gait at a speed.</summary>
    public float FrequencyOf(Gait gait, float froude, float gravity)
    {
        if (!ReferenceEquals(gait, measured))
        {
            measured = gait;
            longest = SlopeStance.Of(body, gait);
            measuredFroude = float.NaN;
        }

        if (froude != measuredFroude || gravity != measuredGravity || slope != measuredSlope)
        {
            measuredFroude = froude;
            measuredGravity = gravity;
            measuredSlope = slope;
            measuredFrequency = GaitSet.FrequencyOf(gait, froude, body.LegLength, gravity, longest.At(slope));
        }

        return measuredFrequency;
    }

    private float WantedLag(int leg)
    {
        LegRig shape = body.Legs[leg];
        bool mirrored = Gait.Symmetry == GaitSymmetry.Leading && Lead == Lead.Right;
        Anatomy.Side side = mirrored == (shape.Side == Anatomy.Side.Left) ? Anatomy.Side.Right : Anatomy.Side.Left;
        float lag = Gait.Phases.Lag(shape.Row, body.Rows, side, Duty);
        return lag - (float)Math.Floor(lag);
    }
}

/// <summary>The side whose foot comes down last in canter and gallop.</summary>
internal enum Lead
{
    Left,
    Right,
}
