using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Data;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>What one creature on the scene performs: sequences the player, the layer and what is brought to a target, and nothing else. Allocates nothing once it is made.</summary>
internal sealed class Performer
{
    /// <summary>How quickly what a standing creature does by itself gives way to an act, per second and per time unit of the act, whichever is quicker: gone before the act's first phase is at its end. And what counts as none.</summary>
    private const float StillRate = 9f;
    private const float StillRatePerUnit = 8f;
    private const float Nothing = 1e-3f;

    /// <summary>How far feet have to be off their places for the ground to bear the body instead.</summary>
    private const float Borne = 0.15f;

    /// <summary>How far lids are shut that see nothing.</summary>
    private const float Asleep = 0.6f;

    /// <summary>How far ahead of the neck's root a snout's target counts at least, parts of the leg.</summary>
    private const float LeastAhead = 0.25f;

    private readonly ActBody body;
    private readonly TrunkRoom room;
    private readonly ActPlayer player = new();
    private readonly ActLayer layer;
    private readonly float[] values = new float[Act.ChannelCount];
    private readonly Mood mood;
    private readonly GroundedEnds ends;
    private ActAim aim;
    private ActAim lastAim;
    private float side = 1f;
    private float over;
    private float still;
    private float stilling;
    private float stillRate = StillRate;

    public Performer(ActBody body, TrunkRoom room)
    {
        this.body = body;
        this.room = room;
        layer = new ActLayer(body, room.Legs);
        mood = new Mood(body.TimeUnit(MotionSettings.Default.Gravity), body.Build);
        ends = new GroundedEnds(body);
    }

    /// <summary>What is performed at present; null for nothing.</summary>
    public Act? Act => player.Act;

    /// <summary>The phase it is in; null for none.</summary>
    public ActPhase? Phase => player.Phase;

    /// <summary>Whether something of an act, or a mood, is to be seen.</summary>
    public bool IsActive { get; private set; }

    /// <summary>Whether feet have to stand for it.</summary>
    public bool HoldsFeet => player.Act is { Footing: ActFooting.Standing };

    /// <summary>Whether it moves the head, or has its eyes shut: it looks at nothing then.</summary>
    public bool HoldsHead => player.Act is { Tool: ActTool.Mouth or ActTool.Brow } || Math.Abs(values[(int)ActChannel.Reach]) > 0.01f || Lids > Asleep;

    /// <summary>How far lids are shut.</summary>
    public float Lids => values[(int)ActChannel.Lids];

    /// <summary>Whether the body is limp for it: nothing of the act is to be seen then, but its time goes by.</summary>
    public bool IsLimp { get; private set; }

    /// <summary>What happened in the last update.</summary>
    public ReadOnlySpan<(Act Act, ActMark Mark, float SecondsAgo)> Marks => player.Marks;

    /// <summary>Forgets these.</summary>
    public void ClearMarks() => player.ClearMarks();

    /// <summary>What is asked of trunk and feet; null for nothing.</summary>
    public BodyLayer? Trunk => IsActive ? layer.Trunk : null;

    /// <summary>Begins an act.</summary>
    /// <param name="act">Which.</param>
    /// <param name="newAim">What is brought where.</param>
    /// <param name="gain">Factor on what the body does.</param>
    /// <param name="seconds">√(leg length / gravity), at its tempo.</param>
    public void Begin(Act act, in ActAim newAim, ActGain gain, float seconds)
    {
        float newSide = newAim.Mirrored ? -1f : 1f;
        KeepAim();
        player.Begin(act, gain, newAim.Plan, newSide, seconds);
        if (!IsActive)
        {
            ends.Forget();
        }

        stillRate = Math.Max(StillRate, StillRatePerUnit / seconds);
        aim = newAim;
        if (newSide != side)
        {
            player.Mirror();
        }

        side = newSide;
        IsActive = true;
        IsLimp = false;
    }

    /// <summary>Leaves the body to its fall.</summary>
    public void GoLimp() => IsLimp = true;

    /// <summary>Feels something from now on.</summary>
    public void Feel(Emotion emotion)
    {
        mood.Feel(emotion);
        IsActive = true;
    }

    /// <summary>Leaves a phase that lasts.</summary>
    public void GoOn() => player.GoOn();

    /// <summary>Ends the act where it is: what was brought to its target lets go of that and of no other.</summary>
    public void Stop()
    {
        if (player.Act != null)
        {
            KeepAim();
        }

        player.Stop();
        IsLimp = false;
    }

    /// <summary>Forgets what it performs. What it feels stays, and shows as if it always had.</summary>
    public void Reset()
    {
        player.Reset();
        ends.Forget();
        mood.Settle();
        still = 0f;
        stilling = 0f;
        IsLimp = false;
        IsActive = mood.IsShown;
        Array.Clear(values, 0, values.Length);
        mood.AddTo(values);
        room.Clamp(values);
        layer.Ask(values, side);
        (layer.Trunk.Still, layer.Trunk.Verve) = (0f, mood.Verve);
    }

    /// <summary>Takes over what another of the same creature performs.</summary>
    public void CopyFrom(Performer other)
    {
        player.CopyFrom(other.player);
        layer.CopyFrom(other.layer);
        other.values.CopyTo(values, 0);
        ends.CopyFrom(other.ends);
        mood.CopyFrom(other.mood);
        aim = other.aim;
        lastAim = other.lastAim;
        side = other.side;
        still = other.still;
        stilling = other.stilling;
        stillRate = other.stillRate;
        IsActive = other.IsActive;
        IsLimp = other.IsLimp;
    }

    /// <summary>Moves the origin of the world.</summary>
    public void Rebase(Vector3 offset)
    {
        aim = aim with { Target = aim.Target + offset };
        lastAim = lastAim with { Target = lastAim.Target + offset };
    }

    /// <summary>Goes on, and asks the way of moving for its part.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="stands">Whether all feet stand.</param>
    /// <param name="root">Where the creature is.</param>
    public void Advance(float dt, bool stands, in RootPlace root)
    {
        player.Advance(dt, mood.Pace, stands || IsLimp);
        if (IsLimp)
        {
            return;
        }

        ends.Advance(dt);
        CriticallyDampedSpring.Advance(ref still, ref stilling, player.Act == null ? 0f : 1f, player.Act == null ? StillRate : stillRate, dt);
        IsActive = player.IsActive || still > Nothing || mood.IsShown;
        if (!IsActive)
        {
            Array.Clear(values, 0, values.Length);
            return;
        }

        player.Values.CopyTo(values, 0);
        mood.Advance(dt, values);

        room.Clamp(values);
        layer.Ask(values, side);
        (layer.Trunk.Still, layer.Trunk.Verve) = (still, mood.Verve);
        (aim, lastAim) = (aim.At(root), lastAim.At(root));
        layer.Aim(lastAim, root.ToModel(lastAim.Target), player.LeftReach);
        layer.Aim(aim, root.ToModel(aim.Target), player.OwnReach);
    }

    /// <summary>Shows values without playing: what an act comes to.</summary>
    public void Show(float[] shown, in ActAim shownAim, in RootPlace root)
    {
        shown.CopyTo(values, 0);
        aim = shownAim;
        side = aim.Mirrored ? -1f : 1f;
        aim.Plan.AddTo(values, values[(int)ActChannel.Reach], side);
        IsActive = true;
        room.Clamp(values);
        layer.Ask(values, side);
        layer.Trunk.Still = 1f;
        layer.Aim(aim, root.ToModel(aim.Target), values[(int)ActChannel.Reach]);
    }

    /// <summary>Has feet of folded legs go along the ground: asked for after each advance, and before trunk and feet are written.</summary>
    /// <param name="ground">That the feet stand on.</param>
    public void LayFeetAlong(in ActGround ground) => layer.LayAlong(ground);

    /// <summary>Forgets how arms and heads came out of the ground: what is shown next does not follow on what was shown before.</summary>
    public void Forget() => ends.Forget();

    /// <summary>Writes all that no leg carries.</summary>
    /// <param name="root">Where the creature is.</param>
    /// <param name="carried">Whether legs carry the trunk.</param>
    /// <param name="ground">That the feet stand on.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space, brought up to date.</param>
    public void Pose(in RootPlace root, bool carried, in ActGround ground, in Pose local, in Pose model)
    {
        layer.Turn(values, side, carried, local);
        ForwardKinematics.LocalToModel(body.Skeleton, local, model);
        Settled = 0f;
        Lifted = 0f;
        over = 0f;
        if (carried)
        {
            RollOver(ground, local, model);
            Settle(ground, local, model);
            GroundedEars.Keep(body, ground, local, model);
            ends.KeepHead(ground, over, local, model);

            // Turned with the head since, ears would lift the body where they give way.
            GroundedEars.Keep(body, ground, local, model);
            LiftOverHead(ground, local, model);
            ends.KeepTail(ground, over, local, model);
            ends.KeepArms(ground, over, layer.Loose > 0f, local, model);
        }
        else if (body.Build == BodyBuild.Legless)
        {
            // A crawler lies on the ground as it is: what it bends down comes to lie there.
            ends.LayDown(ground, Scalar.Clamp(values[(int)ActChannel.ForeDown], 0f, 1f), local, model);
            ends.KeepHead(ground, over, local, model);
        }

        Bring(lastAim, player.LeftReach, root, carried, local, model);
        Bring(aim, player.Act == null ? values[(int)ActChannel.Reach] - player.LeftReach : player.OwnReach, root, carried, local, model);
        if (carried)
        {
            // What hangs on the head goes where that is brought.
            ends.KeepJaw(ground, layer.JawTurn(values), local, model);
            ends.KeepFeelers(ground, over, local, model);
            GroundedEars.Keep(body, ground, local, model);
        }
    }

    /// <summary>Raises out of the ground heads beside the first, which go after that and know nothing of the ground.</summary>
    /// <param name="ground">That the feet stand on.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void KeepFurtherHeadsOffGround(in ActGround ground, in Pose local, in Pose model) => ends.KeepFurtherHeads(ground, over, local, model);

    /// <summary>Raises out of the ground what has swung into it since: tail, feelers and ears, whose springs know less of their skin.</summary>
    /// <param name="ground">That the feet stand on.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void KeepEndsOffGround(in ActGround ground, in Pose local, in Pose model)
    {
        ends.KeepTail(ground, over, local, model);
        ends.KeepFeelers(ground, over, local, model);
        GroundedEars.Keep(body, ground, local, model);
    }

    /// <summary>The joint that an act strikes or sounds with, and its place.</summary>
    public Vector3 PlaceOf(Act act, in Pose model, in RootPlace root, out int joint)
    {
        ActTool tool = act.Tool == ActTool.None && act.IndexOf(ActMark.SoundBegin) >= 0 ? ActTool.Mouth : act.Tool;
        joint = body.Tools.JointOf(tool, side < 0f);
        return joint < 0 ? root.Position : root.ToWorld(body.Tools.PlaceOf(tool, side < 0f, model));
    }

    /// <summary>Keeps what is brought where as that of an act that is over.</summary>
    private void KeepAim() => lastAim = ActAim.Between(lastAim, player.LeftReach, aim, player.OwnReach);

    /// <summary>How far the ground has raised the body that lies on it, metres; negative where it came down to it. 0 of one that rolls over, which the ground has to raise.</summary>
    public float Settled { get; private set; }

    /// <summary>How far it is lifted over its head as it rolls, metres.</summary>
    public float Lifted { get; private set; }

    /// <summary>Brings a body none of whose feet stands to the ground: neither in it nor in the air above it.</summary>
    private void Settle(in ActGround ground, in Pose local, in Pose model)
    {
        if (layer.Loose > 0f && room.Legs.IsFound)
        {
            float lowest = body.BearingSkin.Lowest(ground, model);
            float onBack = Scalar.Smooth((Math.Abs(over) - LyingSide.Flank.Farthest) / (MathF.PI - LyingSide.Flank.Farthest));
            float onFlank = Scalar.Smooth(Math.Abs(over) / LyingSide.Flank.Nearest);
            lowest += onFlank > 0f && body.Arms.Length > 0 ? onFlank * Math.Min(0f, body.ShoulderSkin.Lowest(ground, model) - lowest) : 0f;
            lowest += onBack > 0f ? onBack * Math.Min(0f, body.NeckSkin.Lowest(ground, model) - lowest) : 0f;
            float raised = -Scalar.Smooth(layer.Loose / Borne) * lowest;
            local.Positions[body.Body] += new Vector3(0f, raised, 0f);
            Settled = over == 0f ? raised : 0f;
            ForwardKinematics.LocalToModel(body.Skeleton, local, model);
        }
    }

    /// <summary>Lifts a body that is over by what of its head is in the ground still: a frill or a crest is wider than its neck bends as it rolls. Who lies on its back would hang in the air over it.</summary>
    private void LiftOverHead(in ActGround ground, in Pose local, in Pose model)
    {
        if (over != 0f && layer.Loose > 0f && room.Legs.Flank <= LyingSide.Flank.Farthest)
        {
            Lifted = Scalar.Smooth(layer.Loose / Borne) * Math.Max(0f, -body.HeadSkin.Lowest(ground, model));
            local.Positions[body.Body] += new Vector3(0f, Lifted, 0f);
            ForwardKinematics.LocalToModel(body.Skeleton, local, model);
        }
    }

    /// <summary>Rolls a body that lies over onto its flank.</summary>
    private void RollOver(in ActGround ground, in Pose local, in Pose model)
    {
        over = layer.RollOver(values, side, ground, local);
        if (over != 0f)
        {
            ForwardKinematics.LocalToModel(body.Skeleton, local, model);
        }
    }

    private void Bring(in ActAim what, float fraction, in RootPlace root, bool carried, in Pose local, in Pose model)
    {
        if (!(fraction > 1e-4f) || body.Tools.JointOf(what.Tool, what.Mirrored) < 0)
        {
            return;
        }

        fraction = Math.Min(fraction, 1f);
        Vector3 target = root.ToModel(what.Target);
        switch (what.Tool)
        {
            case ActTool.Mouth or ActTool.Brow:
                PointReach.Head(body, what.Tool, target, Direction(what, target, model), fraction, local, model);
                break;
            case ActTool.Hand:
                PointReach.Limb(body, body.Tools.ArmOf(what.Mirrored), what, target, fraction, local, model);
                break;
            case ActTool.Tail:
                PointReach.Limb(body, body.Tail.Joints, what, target, fraction, local, model);
                break;
        }

        if (!carried && body.Legs == null && body.Build != BodyBuild.Legless)
        {
            // A body that nothing carries goes there itself.
            Vector3 missing = (target - body.Tools.PlaceOf(what.Tool, what.Mirrored, model)) * fraction;
            local.Positions[body.Body] += missing;
            ForwardKinematics.LocalToModel(body.Skeleton, local, model);
        }
    }

    /// <summary>Where the snout is to point: at the target from where the neck begins, as far down as the act says. What is below that point, or behind it, has no direction of its own: the snout points ahead.</summary>
    private Vector3 Direction(in ActAim what, Vector3 target, in Pose model)
    {
        Vector3 way = target - model.Positions[body.Bearers[0]];
        way.Y = 0f;
        way.Z = Math.Max(way.Z, LeastAhead * body.Unit);
        Vector3 level = Vec.Normalize(way, Vector3.UnitZ);
        PortableMath.SinCos(what.SnoutDown, out double sine, out double cosine);
        return (level * (float)cosine) - new Vector3(0f, (float)sine, 0f);
    }
}
