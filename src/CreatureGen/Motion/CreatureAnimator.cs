using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Falling;
using CreatureGen.Motion.Flying;
using CreatureGen.Motion.Grounds;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;
using CreatureGen.Seeding;

namespace CreatureGen.Motion;

/// <summary>
/// Makes a creature go: a game calls <see cref="Update(float, in MotionInput, IGround)"/> each frame and reads where the creature is and how it is posed. One animator for each creature on the scene; the
/// creature and its <see cref="MotionProfile"/> may be shared by any number of them on any threads.
/// </summary>
/// <remarks>
/// <para>Configured by the creature's build alone. An update allocates nothing; only the first on ground of the game's own makes room for what was before it, unless <see cref="Teleport"/> has. The same calls give the same bits.</para>
/// <para>The pose is in the creature's own space, with its root joint at rest: <see cref="Root"/> says where that is in the world.</para>
/// </remarks>
public sealed partial class CreatureAnimator
{
    private readonly Quaternion[] localRotations;
    private readonly Vector3[] localPositions;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;
    private readonly EventQueue events;
    private Locomotion locomotion;
    private readonly SecondaryMotion secondary;
    private readonly HeadGaze? headGaze;
    private readonly SecondHead? secondHead;
    private readonly GroundGate gate = new();
    private Actor? actor;
    private Vector3? lookAt;
    private MotionSettings settings = MotionSettings.Default;
    private RootPlace root = RootPlace.Identity;
    private GazeSettings? gaze;

    /// <summary>An animator for a creature, standing at the origin.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public CreatureAnimator(Creature creature)
        : this(new MotionProfile(creature ?? throw new ArgumentNullException(nameof(creature))))
    {
    }

    /// <summary>An animator for a creature whose profile is at hand: many of a kind share it.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public CreatureAnimator(MotionProfile profile)
    {
        Profile = profile ?? throw new ArgumentNullException(nameof(profile));
        Skeleton skeleton = profile.Subject.Skeleton;
        joints = skeleton.Count;
        localRotations = new Quaternion[joints];
        localPositions = new Vector3[joints];
        modelRotations = new Quaternion[joints];
        modelPositions = new Vector3[joints];
        LocalPose.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, LocalPose, ModelPose);
        int feet = profile.Legs?.Legs.Length ?? 0;
        events = new EventQueue((2 * feet * WalkingMode.MaxSteps) + (profile.Flight != null ? FlyingMode.MaxBeats : 0) + FallingMode.MaxEvents + feet);
        secondary = new SecondaryMotion(profile.Swinging);
        headGaze = profile.Gaze == null ? null : new HeadGaze(profile.Gaze, profile.Subject);
        secondHead = SecondHead.Of(profile.Subject);
        locomotion = new Locomotion(profile, events);
    }

    /// <summary>What is known of the creature's way of going.</summary>
    public MotionProfile Profile { get; }

    /// <summary>Where the creature's root is in the world: on the ground below its middle; set it by <see cref="Teleport"/> or <see cref="Follow"/>. Speeds and gravity are those of the world, whatever the scale.</summary>
    public RootPlace Root => root;

    /// <summary>What can be set; taken up by the next update.</summary>
    /// <exception cref="ArgumentException">A setting is not finite or out of its range.</exception>
    public MotionSettings Settings
    {
        get => settings;
        set
        {
            value.ThrowIfInvalid();
            settings = value;
            if (value.Detail == MotionDetail.Far)
            {
                distant ??= new DistantMotion(Profile);
            }

            if (value.IdleActs > 0f)
            {
                // Here and not in an update, for it takes a while.
                actor ??= new Actor(Acts);
                actor.IdleActs ??= new IdleActs(Acts, Profile.Subject.Habits.Child("acts"));
            }
        }
    }

    /// <summary>A point of the world that head and eyes are to look at; null for none: then it looks about while it stands.</summary>
    /// <exception cref="ArgumentException">The point is not finite, or farther than 10¹² m along an axis.</exception>
    public Vector3? LookAt
    {
        get => lookAt;
        set
        {
            if (value is Vector3 point)
            {
                Finite.RequireWithin(point, RootPlace.Farthest, nameof(LookAt));
            }

            lookAt = value;
        }
    }

    /// <summary>How head and eyes follow what they look at; null for what suits the creature: big heads turn slowly, fish look with their eyes.</summary>
    public GazeSettings? GazeSettings
    {
        get => gaze;
        set => gaze = value;
    }

    /// <summary>The pose in the parents' space, as of the last update. It may be changed before it is used; the next update writes it anew.</summary>
    public Pose LocalPose => new(localRotations, localPositions);

    /// <summary>The pose in model space, as of the last update.</summary>
    public Pose ModelPose => new(modelRotations, modelPositions);

    /// <summary>What happened in the last update.</summary>
    public ReadOnlySpan<MotionEvent> Events => events.Items;

    /// <summary>How many of the ground's answers in the last update counted as no hit: numbers that are not finite, a normal that is not unit, or a point far beyond the ray. More than 0 is an error of the game's ground.</summary>
    public int RefusedHits => gate.Refused;

    /// <summary>The gait at present; null for creatures without legs to stand on.</summary>
    public Gait? Gait => Legs?.Gait;

    /// <summary>Number of feet that it walks on.</summary>
    public int FootCount => Legs?.FootCount ?? 0;

    /// <summary>Whether it goes on its feet at present: not in the air, in water or on the belly.</summary>
    internal bool StandsOnFeet => Mode is { StandsOnFeet: true };

    /// <summary>Whether it is on its feet with its wings folded, or has none that fold.</summary>
    internal bool IsAtRest => Mode is not { IsFolded: false };

    /// <summary>Whether a C-start is under way.</summary>
    internal bool Escapes => Mode is { Escapes: true };

    private WalkingMode? Legs => locomotion.Legs;

    private FallingMode? Mode => locomotion.Mode;

    /// <summary>Metres per second ahead at present; 0 for who lies limp or gets up.</summary>
    public float Speed => (Mode?.Speed ?? 0f) * root.Scale;

    /// <summary>Place in the gait's cycle, 0..1.</summary>
    public float Phase => Mode?.Phase ?? 0f;

    /// <summary>Cycles per second at present.</summary>
    public float Frequency => Mode?.Frequency ?? 0f;

    /// <summary>How a foot is at present.</summary>
    /// <param name="foot">0 up to <see cref="FootCount"/>.</param>
    public FootReport Foot(int foot)
    {
        if (Legs == null || (uint)foot >= (uint)FootCount)
        {
            throw new ArgumentOutOfRangeException(nameof(foot), foot, FormattableString.Invariant($"expected 0..{FootCount - 1}"));
        }

        FootReport report = Legs.Report(foot);
        return Mode is { IsOnFeet: false } ? report with { Phase = FootPhase.Swing, Load = 0f } : report;
    }

    /// <summary>The sharpest turn that it takes on its feet at a speed, with the steps of its present gait: sharper ones that are asked for are turned down to about this. For games that plan ways.</summary>
    /// <param name="speed">Ahead, metres per second, up to 10⁶ either way; 0 for turns on the spot.</param>
    /// <returns>Radians per second; null for what has no legs.</returns>
    /// <exception cref="ArgumentException">The speed is not finite or out of its range.</exception>
    public float? SharpestTurn(float speed)
    {
        Finite.RequireWithin(speed, -1e6f, 1e6f, nameof(speed));
        return Legs?.SharpestTurn(speed, root.Scale, settings);
    }

    /// <summary>Where a socket is in the world as of the last update: what is worn, held or rides there. A rider of its own animator goes along by <see cref="Follow"/>.</summary>
    /// <param name="socket">Number in <see cref="Creature.Sockets"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such socket.</exception>
    public RootPlace Socket(int socket)
    {
        IReadOnlyList<CreatureSocket> sockets = Profile.Subject.Sockets;
        if ((uint)socket >= (uint)sockets.Count)
        {
            throw new ArgumentOutOfRangeException(nameof(socket), socket, FormattableString.Invariant($"expected 0..{sockets.Count - 1}"));
        }

        CreatureSocket frame = sockets[socket];
        Quaternion joint = modelRotations[frame.Joint];
        Vector3 model = modelPositions[frame.Joint] + Rotation.Rotate(joint, frame.Position);
        Quaternion world = Rotation.Multiply(root.Rotation, Rotation.Multiply(joint, frame.Rotation));
        return new RootPlace(root.ToWorld(model), Rotation.Normalize(world), root.Scale);
    }

    /// <summary>Moves on: the creature goes as it is asked, over the ground.</summary>
    /// <param name="dt">Seconds since the last update, 0..0.25; 0 gives the same pose again. What is longer counts as 0.25.</param>
    /// <param name="input">What the creature is to do.</param>
    /// <param name="ground">Where feet find footing.</param>
    /// <exception cref="ArgumentException">A number is not finite or out of its range, or dt is negative. Nothing has changed.</exception>
    /// <exception cref="ArgumentNullException">There is no ground. Nothing has changed.</exception>
    /// <exception cref="Exception">The ground has thrown it. The creature is as it was before, and goes on from there.</exception>
    public void Update(float dt, in MotionInput input, IGround ground)
    {
        input.ThrowIfInvalid();
        CheckedGround sound = Check(ref dt, ground);
        if (Mode != null && !GoesAfar(dt, input, sound))
        {
            Face(root);
            MotionInput asked = actor == null ? input : actor.Begin(dt, root, locomotion, input, settings, IdlesOf(input));
            try
            {
                root = locomotion.Update(root, dt, asked, settings, sound, actor?.Layer, LocalPose);
            }
            catch when (sound.MayThrow)
            {
                actor?.Undo();
                throw;
            }

            Finish(dt);
        }
    }

    /// <summary>
    /// Moves on where the game itself moves the creature: speeds follow from the way it was moved. Where that jumps, the body of what walks catches up with 1.5 g at most while <see cref="Root"/> is where the game says; one
    /// that is put farther than 16 legs away stands there at once.
    /// </summary>
    /// <param name="dt">Seconds since the last update, 0..0.25; what is longer counts as 0.25.</param>
    /// <param name="placement">Where the root is now; its own up is taken for up.</param>
    /// <param name="ground">Where feet find footing.</param>
    /// <exception cref="ArgumentException">A number is not finite, the rotation is not unit, or dt is negative. Nothing has changed.</exception>
    /// <exception cref="ArgumentNullException">There is no ground. Nothing has changed.</exception>
    /// <exception cref="Exception">The ground has thrown it. The creature is as it was before, and goes on from there.</exception>
    public void Follow(float dt, in RootPlace placement, IGround ground)
    {
        placement.Require(nameof(placement));
        CheckedGround sound = Check(ref dt, ground);
        if (FollowsAfar(dt, placement, sound))
        {
            return;
        }

        Face(placement);
        actor?.Begin(dt, root, locomotion, default, settings, IdlesOf(default));
        try
        {
            locomotion.Follow(root, dt, placement, settings, sound, actor?.Layer, LocalPose);
        }
        catch when (sound.MayThrow)
        {
            actor?.Undo();
            throw;
        }

        root = placement;
        Finish(dt);
    }

    /// <summary>Puts the creature somewhere else, standing on its feet there as if it had always been.</summary>
    /// <exception cref="ArgumentException">A number is not finite, or the rotation is not unit. Nothing has changed.</exception>
    /// <exception cref="ArgumentNullException">There is no ground. Nothing has changed.</exception>
    /// <exception cref="Exception">The ground has thrown it. The creature is as it was before, and goes on from there.</exception>
    public void Teleport(in RootPlace placement, IGround ground)
    {
        if (ground == null)
        {
            throw new ArgumentNullException(nameof(ground));
        }

        placement.Require(nameof(placement));
        CheckedGround sound = gate.Open(ground);
        events.Clear();
        actor?.Reset();
        try
        {
            locomotion.Stand(placement, settings, sound, actor?.Layer, LocalPose);
        }
        catch when (sound.MayThrow)
        {
            actor?.Undo();
            throw;
        }

        root = placement;
        distant?.Reset();
        secondary.Reset();
        headGaze?.Reset();
        secondHead?.Reset();
        Finish(0f);
    }

    /// <summary>Moves the origin of the world: everything that is remembered in it moves by the offset, and nothing else changes.</summary>
    /// <param name="offset">Added to all places, metres.</param>
    /// <exception cref="ArgumentException">A number is not finite.</exception>
    public void Rebase(Vector3 offset)
    {
        Finite.Require(offset, nameof(offset));
        root = new RootPlace(root.Position + offset, root.Rotation, root.Scale);
        Mode?.Rebase(offset);
        actor?.Performer.Rebase(offset);
        secondary.Rebase(offset);
    }

    /// <summary>Holds lids and ears; null to let the creature blink and flick its ears by itself.</summary>
    internal void Hold(StandingAct? act)
    {
        if (headGaze != null)
        {
            headGaze.Held = act;
        }

        if (secondHead != null)
        {
            secondHead.Gaze.Held = act;
        }
    }

    private CheckedGround Check(ref float dt, IGround ground)
    {
        if (ground == null)
        {
            throw new ArgumentNullException(nameof(ground));
        }

        if (!(dt >= 0f) || float.IsInfinity(dt))
        {
            throw new ArgumentOutOfRangeException(nameof(dt), dt, "expected finite seconds, not negative");
        }

        dt = Math.Min(dt, WalkingMode.LongestUpdate);
        Fetch();
        events.Clear();
        actor?.ClearEvents();
        return gate.Open(ground);
    }

    /// <summary>The push to the side that the lean of the body balances, so that what hangs on it does not feel it: m/s², world space.</summary>
    private Vector3 Balanced()
    {
        float bank = Mode?.BalancedBank ?? 0f;
        if (bank == 0f)
        {
            return Vector3.Zero;
        }

        PortableMath.SinCos(bank, out double sine, out double cosine);
        return Rotation.Rotate(root.Rotation, Vector3.UnitX) * (float)(settings.Gravity * sine / cosine);
    }

    /// <summary>Tells what carries it where it looks: the chest turns some of the way.</summary>
    private void Face(in RootPlace place)
    {
        if (Legs != null)
        {
            Vector3 seen = lookAt is Vector3 point ? place.ToModel(point) : Vector3.Zero;
            float max = GazeSettings?.MaxYaw ?? (float)PortableMath.Pi;
            Legs.Facing = (seen.X == 0f && seen.Z == 0f) || actor?.Performer is { IsActive: true, HoldsHead: true } ? 0f : Scalar.Clamp(FastTrigonometry.Of(seen.X, seen.Z), -max, max);
        }
    }

    private void Finish(float dt)
    {
        distant?.Fade(dt, LocalPose);
        ForwardKinematics.LocalToModel(Profile.Subject.Skeleton, LocalPose, ModelPose);
        bool near = settings.Detail == MotionDetail.Full;
        bool awake = State is not (BodyState.Limp or BodyState.Rising);
        Performer? performer = awake && actor?.Performer is { IsActive: true } active ? active : null;
        bool looks = awake && performer is not { HoldsHead: true };
        secondHead?.NoteCarried(LocalPose);
        if (headGaze != null && near)
        {
            headGaze.Lids = performer?.Lids ?? 0f;
            headGaze.IsLimp = State == BodyState.Limp;
            headGaze.Update(looks ? lookAt : null, gaze, root, Mode?.Speed ?? 0f, looks ? settings.Idle : 0f, dt, LocalPose, ModelPose);
        }

        secondHead?.NoteLooking(LocalPose);
        Mode?.Give(dt, root, settings.Gravity, LocalPose, ModelPose);
        bool carried = performer != null && StandsOnFeet;
        ActGround ground = carried ? ActGround.Under(Legs!.Feet, root) : ActGround.Level;
        if (performer != null)
        {
            performer.Pose(root, carried, ground, LocalPose, ModelPose);
            actor!.Tell(root, ModelPose);
        }

        MoveSecondHead(awake, looks, near, performer?.Lids ?? 0f, dt);
        if (carried)
        {
            performer!.KeepFurtherHeadsOffGround(ground, LocalPose, ModelPose);
        }

        if (awake && near)
        {
            secondary.Update(root, Mode?.Clearance ?? 0f, Mode?.Incline ?? 0f, Balanced(), dt, LocalPose, ModelPose);
            if (carried)
            {
                performer!.KeepEndsOffGround(ground, LocalPose, ModelPose);
            }
        }
        else
        {
            secondary.Reset();
        }
    }
}
