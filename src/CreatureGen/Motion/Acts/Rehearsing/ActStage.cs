using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>A creature that stands on level ground and shows what an act comes to, by the same legs and chains as on the scene: for looking before it leaps. Allocates nothing once it is made.</summary>
internal sealed class ActStage
{
    private readonly ActBody body;
    private readonly ILocomotionMode? mode;
    private readonly Performer performer;
    private readonly Quaternion[] localRotations;
    private readonly Vector3[] localPositions;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;
    private readonly Vector3[] feet;
    private readonly float standing;
    private (Act? Act, int Phase, double At) moment;
    private readonly float[] values = new float[Act.ChannelCount];

    public ActStage(ActBody body, ILocomotionMode? mode, TrunkRoom room)
    {
        this.body = body;
        this.mode = mode;
        performer = new Performer(body, room);
        int count = body.Skeleton.Count;
        localRotations = new Quaternion[count];
        localPositions = new Vector3[count];
        modelRotations = new Quaternion[count];
        modelPositions = new Vector3[count];
        feet = new Vector3[body.Legs?.Legs.Length ?? 0];
        Local.SetToRest(body.Skeleton);
        mode?.Stand(RootPlace.Identity, MotionSettings.Default, FlatGround.Level, null, Local);
        ForwardKinematics.LocalToModel(body.Skeleton, Local, Model);
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i] = SoleOf(i);
        }

        standing = body.Skin.Lowest(Model);
    }

    /// <summary>The pose shown, in model space, which is the world's.</summary>
    public Pose Model => new(modelRotations, modelPositions);

    private Pose Local => new(localRotations, localPositions);

    /// <summary>Shows a place in an act.</summary>
    public void Show(Act act, int phase, double at, ActGain gain, in ActAim aim)
    {
        bool goesOn = act == moment.Act && (phase > moment.Phase || (phase == moment.Phase && at > moment.At));
        moment = (act, phase, at);
        ActCurve.Write(act, phase, at, gain, values);
        Show(aim, goesOn);
    }

    /// <summary>Shows one channel alone.</summary>
    public void Show(ActChannel channel, float value)
    {
        Array.Clear(values, 0, values.Length);
        values[(int)channel] = value;
        Show(default(ActAim), false);
    }

    /// <summary>Shows values of all channels.</summary>
    public void Show(float[] shown)
    {
        shown.CopyTo(values, 0);
        Show(default(ActAim), false);
    }

    /// <summary>Shows the values.</summary>
    /// <param name="aim">What is brought where.</param>
    /// <param name="goesOn">Whether it is a later moment of what was shown before.</param>
    private void Show(in ActAim aim, bool goesOn)
    {
        if (!goesOn)
        {
            performer.Forget();
        }

        performer.Show(values, aim, RootPlace.Identity);
        Local.SetToRest(body.Skeleton);
        mode?.Update(RootPlace.Identity, 0f, default, MotionSettings.Default, FlatGround.Level, performer.Trunk, Local);
        ForwardKinematics.LocalToModel(body.Skeleton, Local, Model);
        performer.Pose(RootPlace.Identity, body.Legs != null, ActGround.Level, Local, Model);
        if (body.Legs != null)
        {
            performer.KeepFurtherHeadsOffGround(ActGround.Level, Local, Model);
        }
    }

    /// <summary>Where a tool is.</summary>
    public Vector3 PlaceOf(ActTool tool, bool mirrored) => body.Tools.PlaceOf(tool, mirrored, Model);

    /// <summary>How far the worst planted foot is from where it stood: parts of the leg.</summary>
    public float Slip()
    {
        float worst = 0f;
        for (int i = 0; i < feet.Length; i++)
        {
            worst = Math.Max(worst, SlipOf(i));
        }

        return worst;
    }

    /// <summary>How far a foot is from where it stands, its ball or its sole, whichever is nearer: parts of the leg; 0 of one that an act takes.</summary>
    public float SlipOf(int foot)
    {
        ref readonly FootLayer asked = ref performer.Trunk!.Feet[foot];
        if (asked.Way.Y > 0f || asked.AimFraction > 0f || asked.Loose > 0f || asked.Carried > 0f)
        {
            return 0f;
        }

        LegRig leg = body.Legs!.Legs[foot];
        float ball = Vec.Distance(Model.Positions[leg.Ball], leg.Home + asked.Way + new Vector3(0f, leg.BallHeight, 0f));
        return Math.Min(ball, Vec.Distance(SoleOf(foot), feet[foot] + asked.Way)) / leg.Length;
    }

    /// <summary>How much deeper the skin is in the ground than where the creature stands, or would be if the ground did not raise the body, parts of its length; 0 where no ground carries it.</summary>
    public float Sunk() => body.Legs == null && body.Build != BodyBuild.Legless ? 0f : Math.Max(Math.Max(0f, performer.Settled), Math.Min(standing, 0f) - body.Skin.Lowest(Model)) / body.Size;

    /// <summary>How far it hangs in the air over its head, parts of its length: as it rolls it may, as it lies it would be in the ground.</summary>
    public float Lifted() => performer.Lifted / body.Size;

    private Vector3 SoleOf(int foot) => SoleMiddle.Of(body.Legs!.Legs[foot], body.Skeleton, Model);
}
