using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Lab.Runtime;

/// <summary>A living creature.</summary>
internal sealed class Actor
{
    /// <summary>Numbers before the matrices: slot, joints, feet, place, turn, speed, phase, age, state of the body, seconds of the move.</summary>
    private const int HeadLength = 15;
    private const int MaxMoments = 16;
    private const int FootLength = 4;

    private readonly Matrix4x4[] skin;
    private float waited;
    private float age;
    private float moved;

    /// <param name="slot">Where it lives.</param>
    /// <param name="creature">What is seen.</param>
    /// <param name="design">What is kept of it; for a young one, what it will grow up to be.</param>
    /// <param name="mind">What it wants.</param>
    public Actor(int slot, Creature creature, CreatureBlueprint design, Mind mind)
    {
        Slot = slot;
        Creature = creature;
        Design = design;
        Mind = mind;
        Profile = new MotionProfile(creature);
        Animator = new CreatureAnimator(Profile);
        Deeds = new Deeds(Animator);
        Abilities = Abilities.Of(Profile);
        skin = new Matrix4x4[creature.Skeleton.Count];
    }

    public int Slot { get; }

    public Creature Creature { get; }

    public CreatureBlueprint Design { get; }

    public Mind Mind { get; }

    public MotionProfile Profile { get; }

    public CreatureAnimator Animator { get; }

    public Deeds Deeds { get; }

    public Abilities Abilities { get; }

    /// <summary>The joint at which it is pushed.</summary>
    public int Chest => Math.Max(1, Creature.Skeleton.Joints.ToList().FindIndex(joint => joint.Role is JointRole.Chest or JointRole.Spine or JointRole.Body));

    public Vector3 Position => Animator.Root.Position;

    /// <summary>From the creature that is looked at, squared; kept by the stage.</summary>
    public float Distance { get; set; }

    /// <summary>What happened in the last move.</summary>
    public List<Moment> Moments { get; } = [];

    /// <summary>Frames in a row in which others moved and it did not; those that have just come go first.</summary>
    public int Passed { get; private set; } = int.MaxValue / 2;

    public int FrameLength => HeadLength + (FootLength * Animator.FootCount) + (16 * skin.Length);

    public void Place(float x, float y, float z, float yaw, Land land)
    {
        float ground = land.HeightAt(x, z);
        var turn = new Quaternion(0f, (float)Math.Sin(0.5 * yaw), 0f, (float)Math.Cos(0.5 * yaw));
        float level = Abilities.Medium == Medium.Ground ? ground : ground + Math.Max(y, Abilities.Rise);
        Animator.Teleport(new RootPlace(new Vector3(x, Abilities.Medium == Medium.Water ? Math.Min(level, land.Surface) : level, z), turn), land.Ground);
    }

    public void TakePlaceOf(Actor other, Land land)
    {
        RootPlace place = other.Animator.Root;
        Vector3 p = place.Position;
        Vector3 ahead = Rotation.Rotate(place.Rotation, Vector3.UnitZ);
        Place(p.X, p.Y - land.HeightAt(p.X, p.Z), p.Z, (float)Math.Atan2(ahead.X, ahead.Z), land);
    }

    /// <summary>Stands where it is on another ground.</summary>
    public void StandAnew(Land land) => TakePlaceOf(this, land);

    public void LookAt(float x, float y, float z) => Animator.LookAt = float.IsFinite(x + y + z) ? new Vector3(x, y, z) : null;

    public void Wait(float seconds)
    {
        waited = Math.Min(waited + Math.Max(seconds, 0f), 0.25f);
        Passed++;
    }

    /// <summary>Lives on by the time that has passed.</summary>
    /// <param name="stage">Where.</param>
    /// <param name="longest">Seconds at most; what is left waits.</param>
    public void Move(Stage stage, float longest)
    {
        float seconds = Math.Min(waited, longest);
        Passed = 0;
        moved = seconds;
        waited -= seconds;
        age += seconds;
        Animator.Update(seconds, Mind.Decide(this, seconds, stage), stage.Land.Ground);
        foreach (MotionEvent moment in Animator.Events)
        {
            if (KindOf(moment.Kind) is { } kind)
            {
                Tell(new Moment(kind, moment.Position, moment.Strength));
            }
        }

        foreach (ActEvent moment in Animator.ActEvents)
        {
            if (KindOf(moment.Mark) is { } kind)
            {
                Tell(new Moment(kind, moment.Position, 1f));
            }
        }
    }

    /// <summary>Writes itself for the page.</summary>
    /// <returns>The index after what was written.</returns>
    public int Write(float[] frame, int at)
    {
        RootPlace place = Animator.Root;
        int feet = Animator.FootCount;
        frame[at] = Slot;
        frame[at + 1] = skin.Length;
        frame[at + 2] = feet;
        place.Position.CopyTo(frame, at + 3);
        frame[at + 6] = place.Rotation.X;
        frame[at + 7] = place.Rotation.Y;
        frame[at + 8] = place.Rotation.Z;
        frame[at + 9] = place.Rotation.W;
        frame[at + 10] = Animator.Speed;
        frame[at + 11] = Animator.Phase;
        frame[at + 12] = age;
        frame[at + 13] = (float)Animator.State;
        frame[at + 14] = moved;
        at += HeadLength;
        for (int foot = 0; foot < feet; foot++, at += FootLength)
        {
            FootReport report = Animator.Foot(foot);
            report.Place.CopyTo(frame, at);
            frame[at + 3] = report.Phase == FootPhase.Stance ? Math.Max(report.Load, 0.05f) : 0f;
        }

        SkinMatrices.Fill(Creature.Skeleton, Animator.ModelPose, skin);
        MemoryMarshal.Cast<Matrix4x4, float>(skin).CopyTo(frame.AsSpan(at));
        return at + (16 * skin.Length);
    }

    private static MomentKind? KindOf(MotionEventKind kind) => kind switch
    {
        MotionEventKind.FootDown => MomentKind.Footfall,
        MotionEventKind.WingBeat => MomentKind.WingBeat,
        MotionEventKind.WentLimp => MomentKind.Fell,
        MotionEventKind.Rose => MomentKind.Rose,
        _ => null,
    };

    private static MomentKind? KindOf(ActMark mark) => mark switch
    {
        ActMark.SoundBegin => MomentKind.Call,
        ActMark.SoundEnd => MomentKind.CallEnd,
        ActMark.Contact => MomentKind.Contact,
        ActMark.End => MomentKind.Done,
        _ => null,
    };

    private void Tell(Moment moment)
    {
        if (Moments.Count < MaxMoments)
        {
            Moments.Add(moment);
        }
    }
}
