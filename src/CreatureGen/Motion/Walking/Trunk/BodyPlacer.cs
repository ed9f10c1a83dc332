using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Idle;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// Places the trunk over the feet: height, sway and surge from the forces of the feet; yaw, roll and bends with the feet; pitch and roll to the ground; lean in turns; and low enough that no standing leg
/// has to reach too far.
/// </summary>
internal sealed class BodyPlacer
{
    /// <summary>How quickly the trunk follows the ground, per second, and besides for each leg length that it goes.</summary>
    private const float GroundRate = 9f;
    private const float GroundRateOfWay = 1.4f;

    private const float SlopeRate = 6f;
    private const float SlopeFraction = 0.8f;
    private const float LateralSlopeFraction = 1f;

    /// <summary>How far the pelvis of bodies on two legs, whose tracks are narrow, goes over to the inside of a turn, part of the way on which the legs lean as the body does.</summary>
    private const float BipedInwardFraction = 0.8f;

    private const float SurgeCap = 0.04f;

    /// <summary>Share of the back's bend in gaits whose hind feet take turns.</summary>
    private const float StepFlexion = 0.6f;

    /// <summary>Part of the difference between hind and fore body that a leaping trunk does not go along with: nose up as it takes off, it levels out to the landing and does not dive.</summary>
    private const float LeapSteadiness = 0.5f;

    private readonly LeggedBody body;
    private readonly ForceResponse response = new();

    /// <summary>Sums over the legs, by the names of <see cref="LegSums"/>.</summary>
    private readonly FourierSums sums = new();
    private SteadyGait summed;
    private readonly LegSlack slack;
    private float slope;
    private TurnBend turnBend;
    private ChestLook look;
    private TurnLook turnLook;
    private GroundSlope way;
    private ExponentialDecay groundDecay;
    private ExponentialDecay slopeDecay;
    private LegDrop drop;
    private ShiftRoom shiftRoom;

    public BodyPlacer(LeggedBody body)
    {
        this.body = body;
        Trunk = new TrunkChain(body);
        summed = new SteadyGait(body.Legs.Length);
        slack = LegSlack.Of(body);
    }

    /// <summary>The trunk as last placed.</summary>
    public TrunkChain Trunk { get; }

    /// <summary>Height of the ground under hind and fore feet above the root, smoothed, metres.</summary>
    public float HindGround { get; private set; }

    public float ForeGround { get; private set; }

    /// <summary>The same under the hips: they are not over the middle of the feet, and on a slope the ground there is not as high.</summary>
    public float GroundUnderHips => (0.5f * (HindGround + ForeGround)) + (Climb * body.Span.Hips);

    /// <summary>Rise of the ground along the way, over some steps.</summary>
    public float Climb => way.Rise;

    /// <summary>Bend of the trunk into a turn, radians.</summary>
    public float TurnBend => turnBend.Angle;

    /// <summary>How far the head looks into the turn that is to come, radians.</summary>
    public float TurnLook => turnLook.Angle;

    /// <summary>The angle to the inside at which its turn would be in balance, radians.</summary>
    public float Balance { get; private set; }

    /// <summary>Whether the trunk has so far to go until it is straight that it takes its hips away from their feet.</summary>
    public bool IsBent => turnBend.IsBent(body);

    /// <summary>Yaw of the pelvis with the feet, radians.</summary>
    public float PelvisYaw { get; private set; }

    /// <summary>Bend of the back as the feet gather, radians.</summary>
    public float Flexion { get; private set; }

    /// <summary>Passive nod of the neck, radians.</summary>
    public float Nod { get; private set; }

    /// <summary>How far the neck is stretched ahead as the body speeds up, radians; negative for up and back as it brakes.</summary>
    public float NeckReach { get; private set; }

    /// <summary>How far the trunk of a biped is thrown up by its push, radians; negative where it dips to the landing.</summary>
    public float Rock { get; private set; }

    /// <summary>How high the fore body is above its mean height in the bounce of the gait, leg lengths.</summary>
    public float Bounce { get; private set; }

    /// <summary>Fore-aft difference between left and right rear feet, leg lengths.</summary>
    public float Scissor { get; private set; }

    /// <inheritdoc cref="WalkingMode.Fetch"/>
    public int Fetch() => MemoryLines.Touch(ref slope) ^ MemoryLines.Touch(ref turnBend) ^ MemoryLines.Touch(ref way) ^ MemoryLines.Touch(ref drop) ^ sums.Fetch() ^ response.Fetch() ^ Trunk.Fetch();

    /// <summary>Takes over what another has smoothed; all else follows from the feet with the next placing.</summary>
    public void CopyFrom(BodyPlacer other)
    {
        HindGround = other.HindGround;
        ForeGround = other.ForeGround;
        PelvisYaw = other.PelvisYaw;
        Flexion = other.Flexion;
        Nod = other.Nod;
        Scissor = other.Scissor;
        Rock = other.Rock;
        NeckReach = other.NeckReach;
        SlideFraction = other.SlideFraction;
        slope = other.slope;
        turnBend = other.turnBend;
        look = other.look;
        turnLook = other.turnLook;
        way = other.way;
        groundDecay = other.groundDecay;
        slopeDecay = other.slopeDecay;
        drop = other.drop;
        shiftRoom = other.shiftRoom;
    }

    /// <summary>Forgets what was smoothed: the creature has been put somewhere else.</summary>
    public void Reset(ReadOnlySpan<Foot> feet)
    {
        way.Reset(feet, body.LegLength);
        var ground = GroundUnderFeet.Of(body, feet, Climb);
        HindGround = ground.Hind;
        ForeGround = ground.Fore;
        slope = 0f;
        turnBend = default;
        look = default;
        turnLook = default;
        drop = default;
        shiftRoom = default;
    }

    /// <summary>Tells that the root was moved up under the body, metres.</summary>
    public void RootRaised(float height)
    {
        HindGround -= height;
        ForeGround -= height;
    }

    /// <summary>Places the trunk.</summary>
    /// <param name="context">What it goes by.</param>
    /// <param name="layer">What an act asks on top; null for nothing.</param>
    /// <param name="feet">What the feet do.</param>
    /// <param name="poses">Where they have to be.</param>
    public void Place(in BodyContext context, BodyLayer? layer, Span<Foot> feet, ReadOnlySpan<FootPose> poses)
    {
        TrunkTraits traits = body.Traits;
        MotionSettings settings = context.Settings;
        GaitClock clock = context.Clock;
        float length = body.LegLength;
        float act = context.Activity;
        Sum(clock);
        response.Tune(clock.Duty, clock.Shape.ForceDip * DipFraction(context, length));
        float tempo = Math.Max(clock.Frequency, 0.05f);
        float omega = (float)PortableMath.Tau * tempo;
        float scale = settings.Gravity / (omega * omega);
        float cap = clock.Shape.BounceCap * length;
        float bounce = clock.Shape.Bounce * settings.Walking.Bounce * act * (1f + (layer?.Verve ?? 0f));
        float hindRise;
        float foreRise;
        float nod;
        if (body.RidesOnGirdles)
        {
            Vector4 rise = response.Height(sums, 2, scale, cap, out Vector4 nods) * bounce;
            (hindRise, foreRise, nod) = (rise.Hind(), rise.Fore(), nods.Fore());
        }
        else
        {
            hindRise = foreRise = response.Height(sums, feet.Length, scale, cap, out Vector4 nods).All() * bounce;
            nod = nods.All();
        }

        // Feet that come down at once find the body at its height: all of them, or in a leap those of each girdle.
        float poise = Math.Min(-response.Touchdown * scale, cap) * bounce;
        FourierSums.Harmonic first = sums.Harmonics[1];
        float atOnce = FourierSums.Together(first.Cosine.All(), first.Sine.All(), feet.Length);
        float hindAtOnce = FourierSums.Together(first.Cosine.Hind(), first.Sine.Hind(), 2);
        float foreAtOnce = FourierSums.Together(first.Cosine.Fore(), first.Sine.Fore(), 2);
        float leap = body.Rows == 2 ? clock.Shape.Trail : 0f;
        hindRise += poise * Math.Max(atOnce, leap * hindAtOnce);
        foreRise += poise * Math.Max(atOnce, leap * foreAtOnce);
        Bounce = foreRise / length;
        hindRise += clock.Shape.Stretch * act * slack.Hind;
        foreRise += clock.Shape.Stretch * act * slack.Fore;
        float steadied = 0.5f * LeapSteadiness * leap * (foreRise - hindRise);
        hindRise += steadied;
        foreRise -= steadied;
        Nod = Scalar.Clamp(nod * act * traits.Nod / body.NeckLength, -0.5f, 0.5f);
        float emphasis = clock.Shape.Emphasis;
        float swing = act * settings.Walking.Sway;
        float pendulum = settings.Gravity / body.HipHeight / (omega * omega);
        IdlePose idle = shiftRoom.Bound(body, feet, context.Idle, context.Step);
        float sway = Scalar.ClampSoftly((response.Sway(sums, feet.Length, pendulum) * swing * (1f + (0.8f * (emphasis - 1f)))) + idle.Shift, body.MaxSwayIn(context.RootVelocity.Turn * clock.Duty / tempo));
        float stance = context.RootVelocity.Speed * clock.Duty / tempo;
        float surge = response.Surge(sums, feet.Length, scale, stance / body.HipHeight, SurgeCap * length) * act;

        Spread(feet, out Girdle rear, out Girdle front);
        Scissor = rear.Left - rear.Right;
        Balance = FastTrigonometry.Of(context.RootVelocity.Speed * context.RootVelocity.Turn, settings.Gravity);
        turnBend.Follow(body, context.RootVelocity, settings.Gravity, Balance, context.Step);
        look.Follow(body, context.Facing, context.Step);
        turnLook.Follow(context.RootVelocity, settings.Gravity * length, context.Step);
        float spine = settings.Walking.SpineMotion;
        float pelvisYaw = -traits.PelvisYaw * Scissor * spine;
        float chestYaw = body.IsBiped ? traits.ChestYaw * Scissor * spine : -traits.ChestYaw * (front.Left - front.Right) * spine;
        if (body.Legs[0].Lateral)
        {
            // Its ends turn against one another: turned together they would take the hips off their feet.
            float excess = body.Yaw.Excess(0.5f * (pelvisYaw + chestYaw));
            pelvisYaw -= excess;
            chestYaw -= excess;
        }

        PelvisYaw = pelvisYaw;
        float rolling = emphasis * swing;
        float pelvisRoll = (rolling * traits.PelvisRoll * (rear.LeftLoad - rear.RightLoad)) + idle.Roll;
        float chestRoll = rolling * traits.ChestRoll * (body.IsBiped ? rear.LeftLoad - rear.RightLoad : front.LeftLoad - front.RightLoad);
        pelvisYaw += idle.Yaw - (body.IsBiped ? 0f : 0.5f * TurnBend);
        chestYaw += ((body.IsBiped ? 0.35f : 0.5f) * TurnBend) + look.Angle;
        float gather = body.IsBiped ? 0f : 0.5f * ((rear.Left + rear.Right) - (front.Left + front.Right));
        float supple = traits.Flexion * (StepFlexion + ((1f - StepFlexion) * hindAtOnce));
        float arch = body.IsBiped ? 0f : -clock.Shape.Arch * first.Cosine.All() / feet.Length;
        Effort effort = Effort.Of(body, context.Acceleration / settings.Gravity, Climb);
        NeckReach = effort.Neck;
        float tuck = body.IsBiped ? 0f : traits.Flexion * effort.Tuck * spine;
        float flexion = Scalar.Clamp((((supple * Scalar.Clamp(gather, -1f, 1f)) + arch) * act * spine) + tuck, -body.Bends.Pitch, body.Bends.Pitch);
        Flexion = flexion;
        float bank = Balance * traits.Bank * settings.Walking.Bank;
        float inward = body.Legs[0].Lateral ? 0f : (body.IsBiped ? BipedInwardFraction : traits.Inward) * body.HipHeight * bank;

        Follow(context, feet);
        float crouch = clock.Shape.Crouch * length * (body.Legs[0].Lateral ? 0.3f : body.Subject.Plan == Anatomy.BodyPlan.Columnar ? 0.4f : 1f) * (float)Math.Sqrt(act);
        float stoop = Scalar.Smooth(act);
        hindRise += HindGround + context.Idle.Breath - crouch - (stoop * body.HindStoop) - effort.HindDrop;
        foreRise += ForeGround + context.Idle.Breath - context.Bow - crouch - (stoop * body.ForeStoop) - effort.ForeDrop;
        Level(ref hindRise, ref foreRise);
        float lean = body.IsBiped ? (traits.Lean * clock.Shape.Lean * act) + effort.Lean : 0f;
        Rock = clock.Shape.Rock * act * first.Sine.All() / feet.Length;
        float raised = body.Posture.Raised * context.Upright;
        Vector3 rest = Trunk.Rest[0];
        var plan = new TrunkPlan
        {
            Pelvis = new Vector3(rest.X + sway + inward + (body.Legs[0].Lateral ? -slope * body.HipHeight : 0f), rest.Y + hindRise, rest.Z + surge + effort.Shift + (body.Posture.Ahead * context.Upright) - (body.IsBiped ? 0f : rest.Z * SlopeShift.Shortening(Climb))),
            PelvisYaw = pelvisYaw,
            PelvisPitch = (lean < 0f ? Math.Min(lean, -raised) : lean - raised) - (0.5f * flexion) - (body.IsBiped ? Rock : 0f),
            PelvisRoll = pelvisRoll - bank + slope,
            BendYaw = chestYaw - pelvisYaw,
            BendPitch = flexion,
            BendRoll = chestRoll - pelvisRoll,
            ChestPitch = -0.3f * lean,
        };
        plan.Add(layer, body.Bends, ref foreRise);
        Vector3 between = Trunk.Flex(plan);
        Settle(plan, layer, between, rest.Y, foreRise, 0f, 0f);
        MakeRoom(layer, feet, poses, context.Step, out float hindDrop, out float foreDrop);
        if (Math.Max(Math.Abs(hindDrop), Math.Abs(foreDrop)) > 1e-5f * length)
        {
            Settle(plan, layer, between, rest.Y, foreRise, hindDrop, foreDrop);
        }
    }

    /// <summary>Brings the heights of hind and fore body, which are those under the feet, to where the joints of the legs are.</summary>
    private void Level(ref float hindRise, ref float foreRise)
    {
        float rises = foreRise - hindRise;
        foreRise = hindRise + (rises * body.Span.Fore);
        hindRise += rises * body.Span.Hind;
    }

    /// <summary>How far the placed trunk has to come down for the legs.</summary>
    private void MakeRoom(BodyLayer? layer, Span<Foot> feet, ReadOnlySpan<FootPose> poses, float dt, out float hindDrop, out float foreDrop)
    {
        var room = new LegRoom(body);
        for (int i = 0; i < feet.Length; i++)
        {
            if (LegRoom.Weight(body.Legs[i], feet[i]) != 0f)
            {
                room.Add(body.Legs[i], poses[i].Target - HipOf(i, feet[i], out _), ref feet[i], dt);
            }
        }

        room.Find(feet, dt, layer?.Way ?? Vector3.Zero, Math.Abs(HindGround - ForeGround) / Math.Max(body.TrunkLength, 1e-3f), ref drop, out hindDrop, out foreDrop);
    }

    /// <summary>Model place of a leg's hip, its girdle slid and risen with its foot.</summary>
    public Vector3 HipOf(int leg, in Foot foot, out Vector3 slide)
    {
        LegRig shape = body.Legs[leg];
        bool front = body.Rows > 1 && shape.Row == body.Rows - 1;
        TrunkTraits traits = body.Traits;
        float z = Scalar.Clamp((foot.Path.Base.Z - shape.Home.Z) / body.LegLength, -0.6f, 0.6f);
        slide = new Vector3(0f, front ? traits.ForeRise * shape.Length * (foot.Load - 0.45f) * SlideFraction : 0f, (front ? traits.ForeSlide : traits.HindSlide) * shape.Length * z);
        int slot = shape.TrunkSlot;
        return Trunk.Positions[slot] + Rotation.Rotate(Trunk.Turns[slot], (shape.HipRest - Trunk.Rest[slot]) + slide);
    }

    /// <summary>Share of the girdles' rise: none while the creature stands.</summary>
    private float SlideFraction { get; set; }

    /// <summary>The dip of a walk's force fades with speed.</summary>
    private static float DipFraction(in BodyContext context, float length)
    {
        float froude = context.RootVelocity.Speed * context.RootVelocity.Speed / (context.Settings.Gravity * length);
        return Scalar.Clamp(1.3f - (2f * froude), 0.3f, 1f);
    }

    /// <summary>Sums up the legs for the moment: anew if the gait has changed, else as the cycle has gone on.</summary>
    private void Sum(GaitClock clock)
    {
        if (!summed.Is(clock))
        {
            summed.Take(clock);
            sums.Clear();
            for (int i = 0; i < body.Legs.Length; i++)
            {
                LegRig leg = body.Legs[i];
                FastTrigonometry.OfTurns(-clock.Lags[i] - (0.5f * clock.Duty), out float s, out float c);
                float hind = body.RidesOnGirdles && leg.Row == 0 ? 1f : 0f;
                float fore = body.RidesOnGirdles && leg.Row > 0 && leg.Row == body.Rows - 1 ? 1f : 0f;
                sums.Add(s, c, LegSums.WeightsOf(hind, fore, leg.Home.X * clock.Shape.Track));
            }
        }

        FastTrigonometry.OfTurns((float)clock.Phase, out float sine, out float cosine);
        sums.Turn(sine, cosine);
    }

    /// <summary>Fore-aft places and loads of the feet of the rearmost and the foremost pair.</summary>
    private void Spread(ReadOnlySpan<Foot> feet, out Girdle rear, out Girdle front)
    {
        rear = default;
        front = default;
        for (int i = 0; i < feet.Length; i++)
        {
            LegRig leg = body.Legs[i];
            float z = (feet[i].Path.Base.Z - leg.Home.Z) / body.LegLength;
            if (leg.Row == 0)
            {
                rear.Add(leg.Side, z, feet[i].Load);
            }

            if (leg.Row == body.Rows - 1)
            {
                front.Add(leg.Side, z, feet[i].Load);
            }
        }
    }

    /// <summary>Follows the ground under the feet.</summary>
    private void Follow(in BodyContext context, ReadOnlySpan<Foot> feet)
    {
        var ground = GroundUnderFeet.Of(body, feet, Climb);
        float fraction = groundDecay.Fraction((GroundRate + (GroundRateOfWay * Math.Abs(context.RootVelocity.Speed) / body.LegLength)) * context.Step);
        HindGround += (ground.Hind - HindGround) * fraction;
        ForeGround += (ground.Fore - ForeGround) * fraction;
        way.Feel(feet, body.LegLength, context.RootVelocity.Speed, context.Step);
        float wanted = Scalar.Clamp(0.5f * (body.Legs[0].Lateral ? LateralSlopeFraction : SlopeFraction) * ground.Across / Math.Max(body.HalfTrack, 0.05f * body.LegLength), -body.MaxRoll, body.MaxRoll);
        slope += (wanted - slope) * slopeDecay.Fraction(SlopeRate * context.Step);
        SlideFraction = context.Activity;
    }

    /// <summary>Places the bent trunk with the pelvis at its height, and pitches it so that the fore legs' joint comes to its own.</summary>
    private void Settle(in TrunkPlan plan, BodyLayer? layer, Vector3 between, float pelvisRest, float foreRise, float hindDrop, float foreDrop)
    {
        TrunkPlan placed = plan;
        placed.Pelvis.Y -= hindDrop;
        if (body.IsBiped)
        {
            Trunk.Apply(placed, layer);
            return;
        }

        int slot = body.ForeSlot;
        float wanted = Trunk.Rest[slot].Y + foreRise - foreDrop;
        float pitch = plan.PelvisPitch - ((foreRise - foreDrop - (plan.Pelvis.Y - pelvisRest - hindDrop)) / Math.Max(body.TrunkLength, 1e-3f));

        // From pelvis to fore legs: rolled, then pitched as it comes to the wanted height, then yawed.
        FastTrigonometry.SinCos(plan.PelvisRoll, out float sr, out float cr);
        float x = (between.X * cr) - (between.Y * sr);
        float y = (between.X * sr) + (between.Y * cr);
        float squared = (x * x) + (y * y) + (between.Z * between.Z);
        for (int i = 0; i < 2; i++)
        {
            FastTrigonometry.SinCos(pitch, out float sp, out float cp);
            float height = (y * cp) - (between.Z * sp);
            if (i == 0)
            {
                // The trunk bends about its middle: half of what its front goes aside the rear takes back.
                float ahead = (y * sp) + (between.Z * cp);
                FastTrigonometry.SinCos(plan.PelvisYaw, out float sy, out float cy);
                float aside = (x * cy) + (ahead * sy);
                placed.Pelvis.X -= 0.5f * (aside - (Trunk.Rest[slot].X - Trunk.Rest[0].X));
            }

            float level = (float)Math.Sqrt(Math.Max(squared - (height * height), 0f));
            pitch -= Scalar.Clamp((wanted - placed.Pelvis.Y - height) / Math.Max(level, 0.2f * body.TrunkLength), -0.5f, 0.5f);
        }

        placed.PelvisPitch = pitch;
        Trunk.Apply(placed, layer);
    }
}
