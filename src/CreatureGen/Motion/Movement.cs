using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Maths;
using CreatureGen.Motion.Swimming;

namespace CreatureGen.Motion;

/// <summary>Something that a creature does: standing, one of its gaits, flight, swimming, each way of crawling; what leads fliers from standing to flight and back, what a startled fish does, and acts. Immutable.</summary>
public sealed class Movement
{
    private const float PassageSpeed = 0.3f;
    private const float PassageClimb = 0.25f;

    /// <summary>Part of the cruise of an undulating crawler that it makes straight on: waves of the belly are slow.</summary>
    private const float RectilinearSpeed = 0.3f;

    /// <summary>Turn on the spot, radians in the time √(ℓ/g) of legs ℓ long.</summary>
    private const float SpotTurn = 0.3f;

    /// <summary>Aside and back, parts of a walk.</summary>
    private const float AsideSpeed = 0.35f;
    private const float BackSpeed = 0.45f;

    /// <summary>Turn of what has no legs to turn on, radians per second.</summary>
    private const float CruiseTurn = 0.6f;

    /// <summary>How much farther it turns its head when it looks around than while it idles.</summary>
    private const double WideGlances = 2;

    /// <summary>Sinking of a glide: metres for each ahead. Steeper than what lift and drag leave, so that no beat is needed.</summary>
    private const float GlideSink = 0.25f;

    private Movement(string name, MotionInput input, Gait? gait, ClipKind kind = ClipKind.Lasting, SlitherGait crawl = SlitherGait.Undulating, ActAbility? act = null)
    {
        Act = act;
        Name = name;
        Input = input;
        Gait = gait;
        Kind = kind;
        Crawl = crawl;
    }

    /// <summary>What games call it: <c>Idle</c>, <c>Walk</c>, <c>Run</c>, the name of another gait, <c>Fly</c>, <c>Hover</c>, <c>TakeOff</c>, <c>Land</c>, <c>Swim</c>, <c>CStart</c>, <c>Slither</c>, <c>Sidewind</c>, <c>Rectilinear</c> or the name of an act. Unique among those of a creature.</summary>
    public string Name { get; }

    /// <summary>What the creature is asked to do.</summary>
    public MotionInput Input { get; }

    /// <summary>Whether it goes on and on or happens once.</summary>
    public ClipKind Kind { get; }

    /// <summary>The gait it keeps to; null for none.</summary>
    public Gait? Gait { get; }

    /// <summary>How a creature without legs crawls; others take no notice.</summary>
    public SlitherGait Crawl { get; }

    /// <summary>What it performs; null for what goes or stands.</summary>
    public ActAbility? Act { get; }

    /// <summary>The name of its gait, such as <c>BipedWalk</c>; <see cref="Name"/> where there is no gait.</summary>
    public string GaitName => Gait?.Name ?? Name;

    /// <summary>Whether it goes on and on through the air or the water.</summary>
    internal bool IsCruise { get; private init; }

    /// <summary>How wide it looks about while it stands, 1 for the usual.</summary>
    internal double Glances { get; private init; } = 1;

    /// <summary>Whether the motion repeats at the beat of a gait or a stroke; standing still has none.</summary>
    public bool IsCyclic => Kind == ClipKind.Lasting && (Input.Goes || Input.Medium == MotionMedium.Air);

    /// <summary>Everything that a creature does: all ways of going, then every act that it can do.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IReadOnlyList<Movement> Of(MotionProfile profile)
    {
        List<Movement> movements = Going(profile);
        foreach (ActAbility ability in profile.Acts.Possible)
        {
            movements.Add(new Movement(ability.Act.Name, Resting(profile), null, ClipKind.Act, act: ability));
        }

        return movements;
    }

    /// <summary>All ways of going, without the acts, which take a while to find out: Idle, each of its gaits at its most comfortable speed, flight, taking off and landing, swimming, the start of a startled fish to its left, all ways of crawling.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IReadOnlyList<Movement> OfGoing(MotionProfile profile) => Going(profile);

    private static List<Movement> Going(MotionProfile profile)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        var movements = new List<Movement> { new("Idle", Resting(profile), null) };
        if (profile.Gaits != null)
        {
            foreach (GaitSpeed speed in profile.Gaits.Speeds)
            {
                movements.Add(new Movement(NameOf(speed.Gait), new MotionInput(speed.Comfortable), speed.Gait));
            }
        }

        if (profile.Flight != null)
        {
            movements.Add(new Movement("Fly", new MotionInput(profile.Flight.CruiseSpeed, Medium: MotionMedium.Air), null) { IsCruise = true });
            movements.Add(new Movement("Hover", new MotionInput(0f, Medium: MotionMedium.Air), null));
        }

        if (profile.Flight != null && profile.Legs != null)
        {
            float speed = PassageSpeed * profile.Flight.CruiseSpeed;
            float climb = PassageClimb * profile.Flight.CruiseSpeed;
            movements.Add(new Movement("TakeOff", new MotionInput(speed, ClimbRate: climb, Medium: MotionMedium.Air), null, ClipKind.TakeOff));
            movements.Add(new Movement("Land", new MotionInput(speed, ClimbRate: -climb), null, ClipKind.Landing));
        }

        if (profile.Swim != null)
        {
            float speed = profile.Swim.CruiseSpeed;
            movements.Add(new Movement("Swim", new MotionInput(speed), null) { IsCruise = true });
            if (profile.Swim.Style is SwimStyle.Carangiform or SwimStyle.Anguilliform)
            {
                movements.Add(new Movement("CStart", new MotionInput(speed, Escape: EscapeTurn.Left), null, ClipKind.Escape));
            }
        }

        if (profile.Slither != null)
        {
            float speed = profile.Slither.CruiseSpeed;
            movements.Add(new Movement("Slither", new MotionInput(speed), null));
            movements.Add(new Movement("Sidewind", new MotionInput(speed), null, crawl: SlitherGait.Sidewinding));
            movements.Add(new Movement("Rectilinear", new MotionInput(RectilinearSpeed * speed), null, crawl: SlitherGait.Rectilinear));
        }

        return movements;
    }

    /// <summary>Whether a creature does this: another's gaits need other legs, another's flight wings.</summary>
    internal bool IsOf(MotionProfile profile) => Act is { } ability
        ? profile.Acts.Possible.Any(own => own.Act == ability.Act)
        : Going(profile).Concat(Manoeuvres(profile)).Any(own => own.Name == Name && own.GaitName == GaitName);

    /// <summary>What asks nothing of it: it stands, lies or hangs in the water; a flier without legs hovers.</summary>
    private static MotionInput Resting(MotionProfile profile) => new(0f, Medium: profile.Flight != null && profile.Legs == null ? MotionMedium.Air : MotionMedium.Ground);

    /// <summary>What a player has it do beside them, and that repeats: turning, going aside, backing up, looking around, banking, gliding.</summary>
    internal static IReadOnlyList<Movement> Manoeuvres(MotionProfile profile)
    {
        var movements = new List<Movement>();
        if (profile.Gaits is { } gaits && profile.Legs is { } legs)
        {
            Gait walk = gaits.Speeds[0].Gait;
            float speed = gaits.Speeds[0].Comfortable;
            float turn = SpotTurn / (float)Math.Sqrt(legs.LegLength / StandardGravity.Acceleration);
            movements.Add(new Movement("TurnLeft", new MotionInput(0f, turn), walk));
            movements.Add(new Movement("TurnRight", new MotionInput(0f, -turn), walk));
            movements.Add(new Movement("StrafeLeft", new MotionInput(0f, Sideways: AsideSpeed * speed), walk));
            movements.Add(new Movement("StrafeRight", new MotionInput(0f, Sideways: -AsideSpeed * speed), walk));
            movements.Add(new Movement("Reverse", new MotionInput(-BackSpeed * speed), walk));
        }
        else
        {
            float cruise = profile.Swim?.CruiseSpeed ?? profile.Slither?.CruiseSpeed ?? profile.Flight?.CruiseSpeed ?? 0f;
            MotionMedium medium = profile.Flight != null ? MotionMedium.Air : MotionMedium.Ground;
            if (cruise > 0f)
            {
                movements.Add(new Movement("TurnLeft", new MotionInput(cruise, CruiseTurn, Medium: medium), null));
                movements.Add(new Movement("TurnRight", new MotionInput(cruise, -CruiseTurn, Medium: medium), null));
            }
        }

        if (profile.Gaze != null)
        {
            movements.Add(new Movement("LookAround", Resting(profile), null) { Glances = WideGlances });
        }

        if (profile.Flight is { } wings && profile.Legs != null)
        {
            movements.Add(new Movement("BankLeft", new MotionInput(wings.CruiseSpeed, CruiseTurn, Medium: MotionMedium.Air), null));
            movements.Add(new Movement("BankRight", new MotionInput(wings.CruiseSpeed, -CruiseTurn, Medium: MotionMedium.Air), null));
        }

        if (profile.Flight is { GlidesBetweenBeats: true } flight)
        {
            movements.Add(new Movement("Glide", new MotionInput(flight.CruiseSpeed, ClimbRate: -GlideSink * flight.CruiseSpeed, Medium: MotionMedium.Air), null));
        }

        return movements;
    }

    /// <summary>The same at another speed. Creatures go no faster than they can, whatever is asked.</summary>
    /// <param name="speed">Metres per second ahead.</param>
    /// <exception cref="ArgumentException">The speed is not finite.</exception>
    public Movement At(float speed)
    {
        Finite.Require(speed, nameof(speed));
        return new Movement(Name, Input with { Speed = speed }, Gait, Kind, Crawl, Act);
    }

    /// <summary>An animator of a creature that stands at the origin and keeps to the movement's gait or way of crawling from its first step.</summary>
    internal CreatureAnimator Begin(MotionProfile profile, IGround ground)
    {
        var animator = new CreatureAnimator(profile);
        MotionSettings settings = animator.Settings;
        settings.Walking = settings.Walking with { Gait = Gait };
        settings.Slithering = settings.Slithering with { Gait = Crawl };
        animator.Settings = settings;
        animator.Teleport(animator.Root, ground);
        return animator;
    }

    /// <summary>Games look for Walk and Run, whatever walks.</summary>
    private static string NameOf(Gait gait) => gait.Name switch
    {
        "BipedWalk" or "Waddle" => "Walk",
        "BipedRun" or "WaddleRun" => "Run",
        _ => gait.Name,
    };
}
