using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Gaits;
using CreatureGen.Motion.Toolkit.Steps;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>
/// Where a creature is in its cycle, and the numbers of its gait at present. Gaits change by sliding their constants, never their poses: each lag by at most 0.30 cycle and the duty by at most 0.35
/// in a cycle, so that no leg's phase runs backwards; all else at 2 s⁻¹.
/// </summary>
internal sealed class GaitClock
{
    /// <summary>The slowest that a change of gaits makes the clock, as part of the new gait's own frequency.</summary>
    private const float SlowestFraction = 0.1f;

    /// <summary>Cycles per second that a body that goes takes at the least, √(g/leg): of one that brakes hard what is left of its faster gait takes nearly all of the tempo, and a foot in the air would wait for a place ever farther off.</summary>
    private const float SlowestGoing = 0.08f;

    private const float LagPerCycle = 0.30f;
    private const float DutyPerCycle = 0.35f;
    private const float ShapeRate = 2f;

    /// <summary>Yaw of the body in one cycle on the spot, radians.</summary>
    private const float YawPerCycle = 0.45f;

    /// <summary>The same at most, where steps would come quicker than its mass lets them.</summary>
    private const float WidestYawPerCycle = 0.8f;

    /// <summary>Seconds ahead of which the speed decides how quick steps are.</summary>
    private const float Foresight = 0.25f;

    /// <summary>How quickly a change of that, or of how long steps are, is taken up, per second: feet would roll and fold another way at once where a gait changes.</summary>
    private const float GainRate = 8f;

    /// <summary>How quickly the tempo of who comes to a stand, for good or to go the other way, falls at most, cycles per second in a second, parts of g/leg: its last steps are short instead of slow.</summary>
    private const float TempoFall = 0.05f;

    /// <summary>The same of who goes on after all before it stands: the body's bounce goes by the tempo, and jumps where that does.</summary>
    private const float TempoFallOfGoing = 0.4f;

    /// <summary>Cycles per second at the least by which seconds of a cycle are told.</summary>
    private const float SlowestShown = 0.1f;

    /// <summary>Times that a rate of turning is brought down to what steps can follow, by half at most.</summary>
    private const int TurnTrials = 4;

    /// <summary>How quickly it goes up or down at the most, √(leg·g): about 1.8 m/s on the legs of a man (Margaria et al. 1966).</summary>
    private const float QuickestClimb = 0.6f;

    /// <summary>Rise along the way below which that slows nobody down.</summary>
    private const float LeastClimb = 0.05f;

    /// <summary>Times that a speed is brought down to what steps on a slope allow, and how much too quick these may be left.</summary>
    private const int SlopeTrials = 8;
    private const float SlopeTolerance = 1.02f;

    /// <summary>Radians per second from which on it is looked for how sharp a turn is possible.</summary>
    private const float SharpestAsked = 20f;

    /// <summary>Time of a swing in which no leg is stretched out behind, and from which on it has all the time for it, √(leg/g).</summary>
    private const float HurriedSwing = 0.6f;
    private const float UnhurriedSwing = 1.6f;

    private readonly LeggedBody body;
    private readonly float[] lags;
    private readonly float quickest;
    private float frequencyRest;
    private ExponentialDecay shapeDecay;
    private ExponentialDecay gainDecay;
    private ExponentialDecay lengthDecay;
    private float gainAhead;
    private float paceFroude;
    private Gait? measured;
    private float measuredFroude;
    private float measuredGravity;
    private float measuredSlope;
    private float measuredFrequency;
    private float measuredLength = 1f;
    private SlopeStance longest;
    private float slope;
    private bool isKept;

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

    /// <summary>Cycles per second: no change of gaits lets it jump, for the heights of the body's bounce and the ways of its sway go by the square of it, and feet pitch by it.</summary>
    public float Frequency { get; private set; }

    /// <summary>Seconds of a cycle, 10 at most.</summary>
    public float Cycle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 1f / Math.Max(Frequency, SlowestShown);
    }

    /// <summary>Seconds of a swing.</summary>
    public float Swing => (1f - Duty) * Cycle;

    /// <summary>How long steps are, of those that go straight ahead on level ground at the same speed, 0..1: in a turn and on slopes they come quicker, and are shorter for it.</summary>
    public float Length { get; private set; } = 1f;

    /// <summary>Part of the cycle that a foot is down.</summary>
    public float Duty { get; private set; }

    /// <summary>The side that leads in canter and gallop.</summary>
    public Lead Lead { get; private set; }

    /// <summary>How far legs of the hindmost pair are stretched out behind in the air, 0..1: less the shorter that is, or they would be flung there and back.</summary>
    /// <param name="gravity">Metres of the model per second squared.</param>
    public float TrailIn(float gravity)
    {
        float swing = Swing * (float)Math.Sqrt(gravity / body.LegLength);
        return Shape.Trail * Scalar.Smooth((swing - HurriedSwing) / (UnhurriedSwing - HurriedSwing));
    }

    /// <summary>Lag of each leg's touchdown, 0..1.</summary>
    public ReadOnlySpan<float> Lags => lags;

    /// <summary>A leg's place in its own cycle, 0..1: stance up to the duty, then swing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float LegPhase(int leg) => StepPhase.Place((float)Phase, lags[leg]);

    /// <summary>Asks memory for what it knows.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() => MemoryLines.Touch(ref paceFroude) ^ MemoryLines.Touch(ref Shape.Lift) ^ MemoryLines.Touch(ref Shape.Arch) ^ MemoryLines.Touch(ref longest) ^ MemoryLines.Touch(lags, body.Legs.Length);

    /// <summary>Takes over the place and the numbers of another.</summary>
    public void CopyFrom(GaitClock other)
    {
        Gait = other.Gait;
        Shape = other.Shape;
        Phase = other.Phase;
        Frequency = other.Frequency;
        Length = other.Length;
        Duty = other.Duty;
        Lead = other.Lead;
        other.lags.CopyTo(lags, 0);
        frequencyRest = other.frequencyRest;
        shapeDecay = other.shapeDecay;
        gainDecay = other.gainDecay;
        lengthDecay = other.lengthDecay;
        gainAhead = other.gainAhead;
        paceFroude = other.paceFroude;
        slope = other.slope;
        isKept = other.isKept;
        measured = other.measured;
        measuredFroude = other.measuredFroude;
        measuredGravity = other.measuredGravity;
        measuredSlope = other.measuredSlope;
        measuredFrequency = other.measuredFrequency;
        measuredLength = other.measuredLength;
        longest = other.longest;
    }

    /// <summary>Takes a gait at once: only while all feet stand.</summary>
    public void Restart(Gait gait, float froude, Lead lead)
    {
        Gait = gait;
        Lead = lead;
        Shape = GaitShape.Of(gait);
        Duty = gait.Duty.At(froude);
        frequencyRest = 0f;
        isKept = false;
        for (int i = 0; i < lags.Length; i++)
        {
            lags[i] = WantedLag(i);
        }
    }

    /// <summary>Begins to go over to another gait, at the tempo that it has: the steps are those of the speed that the body will have, and so is what differs.</summary>
    public void Change(Gait gait, float gravity, Lead lead)
    {
        frequencyRest += FrequencyOf(Gait, paceFroude, gravity) - FrequencyOf(gait, paceFroude, gravity);
        Gait = gait;
        Lead = lead;
    }

    /// <summary>Lets the numbers go on their way.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="velocity">How the body goes.</param>
    /// <param name="gravity">Metres per second squared.</param>
    /// <param name="pace">Speed, in slow walks, 0..1: what of a turn is done on the spot.</param>
    /// <param name="rise">Of the ground along the way: long strides are shorter uphill and downhill.</param>
    /// <param name="stride">Length of strides, a factor.</param>
    /// <param name="haste">How much quicker than it goes by itself it steps at most where it moves farther in a stance than its feet reach, a factor.</param>
    public void Slide(float dt, in RootVelocity velocity, float gravity, float pace, float rise, float stride = 1f, float haste = 1f)
    {
        float unit = gravity * body.LegLength;

        // A body that speeds up takes the steps of the speed that it will have: else the first of them would be lunges.
        float speed = Math.Abs(velocity.Speed);
        float gain = Math.Max(Math.Abs(velocity.SpeedAfter(Foresight)) - speed, 0f);
        gainAhead = dt > 0f ? gainAhead + ((gain - gainAhead) * gainDecay.Fraction(GainRate * dt)) : gain;
        speed += gainAhead;
        float froude = ((speed * speed) + (velocity.Sideways * velocity.Sideways)) / unit;
        paceFroude = froude;
        slope = rise;
        float fraction = shapeDecay.Fraction(ShapeRate * dt);
        Shape.Approach(Gait, fraction);
        frequencyRest -= frequencyRest * fraction;

        // What is left of a much slower gait must not stop the clock: feet in the air would never come down.
        float own = FrequencyOf(Gait, froude, gravity);
        float straight = Math.Max(own + frequencyRest, SlowestFraction * own) / stride;
        float yaw = Math.Abs(velocity.Turn) * (1f - (0.5f * pace));
        float spot = Math.Min(yaw / YawPerCycle, Math.Max(quickest, yaw / WidestYawPerCycle));
        float needed = Math.Max(Math.Max(straight, spot), Math.Min(FrequencyInTurn(body.StepRanges, velocity.Speed, velocity.Sideways, velocity.Turn, straight, Duty), haste * quickest));
        bool halts = velocity.IsToStand || velocity.TurnsBack;
        float fall = halts ? TempoFall : TempoFallOfGoing;
        float kept = halts || isKept ? Frequency - (fall * gravity / body.LegLength * dt) : 0f;
        isKept = kept > needed;
        Frequency = Math.Max(Math.Max(needed, kept), SlowestGoing * (float)Math.Sqrt(gravity / body.LegLength));
        float length = Math.Min(measuredLength * straight / Frequency, 1f);
        Length = dt > 0f ? Length + ((length - Length) * lengthDecay.Fraction(GainRate * dt)) : length;
        float cycle = Frequency * dt;
        float duty = DutyInTurn(Gait, froude, velocity.Turn, unit);
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

    /// <summary>
    /// The speed that a creature goes on a slope or a flight of stairs when it is asked for one: less where shorter strides would come quicker than its mass lets them,
    /// and so much that it goes up and down no quicker than who runs up stairs with all his might.
    /// </summary>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="gravity">Metres per second squared.</param>
    public float OnSlope(float speed, float gravity)
    {
        float unit = gravity * body.LegLength;
        float steepest = QuickestClimb * (float)Math.Sqrt(unit) / Math.Max(Math.Abs(slope), LeastClimb);
        speed = Scalar.Clamp(speed, -steepest, steepest);
        float stance = longest.At(slope);
        for (int i = 0; stance < longest.Level && i < SlopeTrials; i++)
        {
            // What is quick enough on the level is so here.
            float froude = speed * speed / unit;
            float level = GaitSet.FrequencyOf(Gait, froude, body.LegLength, gravity, longest.Level, quickest);
            float here = GaitSet.FrequencyOf(Gait, froude, body.LegLength, gravity, stance, quickest);
            float most = Math.Max(quickest, level);
            if (here <= SlopeTolerance * most)
            {
                break;
            }

            speed *= most / here;
        }

        return speed;
    }

    /// <summary>The rate of turning, up to what is asked, at which steps as quick as the creature's mass lets them still take all feet along.</summary>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="turn">That is asked, radians per second.</param>
    /// <param name="gravity">Metres per second squared.</param>
    public float ReachableTurn(float speed, float turn, float gravity)
    {
        if (turn == 0f)
        {
            // As most go: a power is saved, a hundredth of the update of a walker.
            return turn;
        }

        float unit = gravity * body.LegLength;
        float froude = speed * speed / unit;
        float straight = GaitSet.FrequencyOf(Gait, froude, body.LegLength, gravity, longest.Level, quickest);
        for (int i = 0; i < TurnTrials; i++)
        {
            float needed = FrequencyInTurn(body.WidestSteps, speed, 0f, turn, straight, DutyInTurn(Gait, froude, turn, unit));
            float max = Math.Max(quickest, straight);
            if (needed <= max)
            {
                break;
            }

            turn *= Math.Max(max / needed, 0.5f);
        }

        return turn;
    }

    /// <summary>The sharpest turn at a speed that the steps of the present gait and the grip of the feet allow, radians per second.</summary>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="bounds">Give the grip.</param>
    /// <param name="gravity">Metres per second squared.</param>
    public float SharpestTurn(float speed, in VelocityBounds bounds, float gravity)
    {
        float turn = SharpestAsked;
        float before;
        do
        {
            before = turn;
            turn = ReachableTurn(speed, before, gravity);
        }
        while (turn < 0.999f * before);
        return speed == 0f ? turn : Math.Min(turn, bounds.Aside / Math.Abs(speed));
    }

    /// <summary>Cycles per second at which no foot goes farther in a stance than its range.</summary>
    private float FrequencyInTurn(StepRange[] ranges, float speed, float sideways, float turn, float straight, float duty)
    {
        if (turn == 0f && sideways == 0f)
        {
            return 0f;
        }

        float half = 0.5f * Math.Abs(speed) * duty / straight;
        float max = 0f;
        for (int i = 0; i < ranges.Length; i++)
        {
            StepRange range = ranges[i];
            Vector3 home = body.GoingHomes[i];
            float aside = (sideways + (turn * home.Z)) / range.Aside;
            float along = (speed - (turn * home.X)) / Math.Max(range.Ahead, half);
            max = Math.Max(max, (aside * aside) + (along * along));
        }

        return 0.5f * duty * (float)Math.Sqrt(max);
    }

    /// <summary>Part of the cycle that a foot is down in a turn: by the speed of the foot that is farthest from the pivot.</summary>
    private float DutyInTurn(Gait gait, float froude, float turn, float unit)
    {
        float fastest = turn * body.FarthestFoot;
        return gait.Duty.At(Math.Max(froude, fastest * fastest / unit));
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
            float stance = longest.At(slope);
            measuredFrequency = GaitSet.FrequencyOf(gait, froude, body.LegLength, gravity, stance, quickest);
            measuredLength = stance < longest.Level ? GaitSet.FrequencyOf(gait, froude, body.LegLength, gravity, longest.Level, quickest) / measuredFrequency : 1f;
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
