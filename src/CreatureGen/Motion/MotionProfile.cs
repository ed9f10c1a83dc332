using System;
using System.Threading;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Rehearsing;
using CreatureGen.Motion.Distance;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Falling;
using CreatureGen.Motion.Floating;
using CreatureGen.Motion.Flying;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Slithering;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Motion.Winged;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>What follows from a creature's build for its motion: worked out once, immutable, shared by all animators of the creature.</summary>
public sealed class MotionProfile
{
    private readonly Lazy<CreatureActs> acts;

    /// <summary>Works out how a creature goes.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public MotionProfile(Creature creature)
        : this(creature, null)
    {
    }

    /// <summary>The same with gaits of the game's own choice.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="gaits">Its gaits, or null for those of its build.</param>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public MotionProfile(Creature creature, GaitSet? gaits)
        : this(new MotionSubject(creature), gaits)
    {
    }

    /// <summary>Works out how a body goes, wherever it is from.</summary>
    /// <param name="subject">The body.</param>
    /// <param name="gaits">Its gaits, or null for those of its build.</param>
    /// <exception cref="ArgumentNullException">There is no body.</exception>
    public MotionProfile(MotionSubject subject, GaitSet? gaits = null)
    {
        Subject = subject ?? throw new ArgumentNullException(nameof(subject));
        Legs = LeggedBody.Of(subject);
        if (Legs != null)
        {
            Gaits = gaits ?? GaitChoice.For(Legs, MotionSettings.Default.Gravity);
            WeightShift.Find(Legs, Gaits);
        }

        Wings = Legs == null ? null : CarriedWings.Of(Legs);
        switch (subject.Kind)
        {
            case LocomotionKind.Flying:
                Flight = FlightProfile.Of(subject);
                break;
            case LocomotionKind.Swimming:
                Swim = SwimProfile.Of(subject);
                break;
            default:
                Slither = Legs == null ? SlitherProfile.Of(subject) : null;
                break;
        }

        Float = Legs == null || Swim != null ? null : FloatProfile.Of(Legs);
        Fall = new Lazy<FallProfile>(() => FallProfile.Of(subject, Legs, Gaits, FindLying), LazyThreadSafetyMode.ExecutionAndPublication);
        Distant = new Lazy<DistantBody?>(() => DistantRecorder.Of(this), LazyThreadSafetyMode.ExecutionAndPublication);
        Gaze = subject.Skeleton.FirstOf(JointRole.Head) >= 0 ? GazeRig.Of(subject.Skeleton) : null;
        acts = new Lazy<CreatureActs>(RehearseActs);
        Swinging = SecondaryMotion.Of(subject, Legs != null && !Legs.HasAbdomen);
    }

    /// <summary>The body that goes.</summary>
    public MotionSubject Subject { get; }

    /// <summary>Its gaits and their speeds; null for creatures without legs to stand on.</summary>
    public GaitSet? Gaits { get; }

    /// <summary>Length of its rearmost legs from hip to ground, metres; 0 without legs.</summary>
    public float LegLength => Legs?.LegLength ?? 0f;

    /// <summary>What it can do beside going, and why not what it cannot. Worked out when it is first asked for, which takes some ten milliseconds.</summary>
    public CreatureActs Acts => acts.Value;

    /// <summary>How it flies; null when it does not.</summary>
    internal FlightProfile? Flight { get; }

    /// <summary>How it swims; null when it does not.</summary>
    internal SwimProfile? Swim { get; }

    /// <summary>How it crawls; null when it has legs.</summary>
    internal SlitherProfile? Slither { get; }

    /// <summary>Neck, head and eyes; null without a head.</summary>
    internal GazeRig? Gaze { get; }

    /// <summary>What swings by itself.</summary>
    internal SwingingChain[] Swinging { get; }

    /// <summary>The body as its walk sees it; null without legs.</summary>
    internal LeggedBody? Legs { get; }

    /// <summary>Wings that it carries as it goes on its legs; null for fliers, and for what has none or has them on its flanks as it was grown.</summary>
    internal CarriedWings? Wings { get; }

    /// <summary>How it floats and paddles; null without legs, and for what swims.</summary>
    internal FloatProfile? Float { get; }

    /// <summary>How it falls, lies and gets up; worked out when it is first asked for.</summary>
    internal Lazy<FallProfile> Fall { get; }

    /// <summary>What is seen of it from afar; null for what does not walk, or flies too. Worked out when it is first asked for.</summary>
    internal Lazy<DistantBody?> Distant { get; }

    /// <summary>A way of moving of its own for one of the creature on the scene.</summary>
    /// <param name="events">Receives what happens.</param>
    /// <param name="legs">The part of it that walks; null without legs.</param>
    /// <returns>Null for a creature that does not move by itself.</returns>
    internal ILocomotionMode? Begin(EventQueue events, out WalkingMode? legs)
    {
        legs = Legs == null ? null : new WalkingMode(Legs, Gaits!, events, Wings);
        return Flight != null ? new FlyingMode(Flight, legs, events)
            : Swim != null ? new SwimmingMode(Swim)
            : Slither != null ? new SlitheringMode(Slither)
            : legs;
    }

    private LyingManner? FindLying()
    {
        ActAbility lie = Acts.RehearseLyingOnBelly();
        return lie.IsPossible ? new LyingManner(lie.Act, lie.Parts, ActTempo.Of(lie.Act, Acts.Body), Acts.Body, Acts.Room) : null;
    }

    private CreatureActs RehearseActs()
    {
        var body = new ActBody(Subject, Legs);
        return new CreatureActs(body, new Rehearsal(body, () => Begin(new EventQueue(0), out _)));
    }
}
