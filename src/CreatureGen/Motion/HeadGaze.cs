using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Rigging;
using CreatureGen.Seeding;

namespace CreatureGen.Motion;

/// <summary>Where head and eyes look: at what the game says, else about while the creature stands; and when it blinks and flicks its ears.</summary>
internal sealed class HeadGaze
{
    /// <summary>Leg or body lengths per second above which nobody looks about.</summary>
    private const float Still = 0.05f;

    /// <summary>How far a swimmer turns a head that sits on its trunk without a neck, radians: the eyes do the rest.</summary>
    private const float FishYaw = 0.15f;

    private const float FishPitch = 0.1f;

    /// <summary>How far shut the lids of a limp body are, and how quickly they come there, per second.</summary>
    private const float LimpLids = 0.85f;
    private const float SlackRate = 2.5f;

    /// <summary>How quickly ears begin and leave off to flick where that is in the middle of one, per second: they would snap.</summary>
    private const float FlickFade = 6f;

    /// <summary>Fastest that lids go, from open to shut per second: a little faster than a blink. A second blow, or who gets up in the midst of a blink, would open or shut them at once.</summary>
    private const float FastestLid = 20f;

    /// <summary>How long who is struck has its eyes shut, blinks.</summary>
    private const double WinceLength = 2.5;

    private readonly GazeRig rig;
    private readonly Seed habits;
    private readonly Seed blinks;
    private readonly GazeSettings head;
    private readonly Eyelids? lids;
    private readonly Ears? ears;
    private readonly Seed flicks;
    private readonly float flickPeriod;
    private readonly float blinkPeriod;
    private GazeState state;
    private double seconds;
    private float slack;
    private float shown;
    private bool isShown;
    private float flickWeight;
    private bool isLimp;
    private double winced = double.NegativeInfinity;

    /// <summary>Gives a creature habits.</summary>
    /// <param name="rig">Its head.</param>
    /// <param name="subject">Big ones are slow; fish look with their eyes; no two of a species look about or blink together.</param>
    public HeadGaze(GazeRig rig, MotionSubject subject)
        : this(rig, subject, subject.Habits)
    {
    }

    /// <summary>Gives a head habits of its own.</summary>
    public HeadGaze(GazeRig rig, MotionSubject subject, Seed habits)
    {
        float mass = subject.Mass.Mass;
        this.rig = rig;
        this.habits = habits;
        blinks = habits.Child("blinks");

        // Big heads turn slowly: 10 s⁻¹ for a cat, 4 for a cow.
        float rate = (float)Scalar.Clamp(12 * PortableMath.Pow(mass, -0.17), 2.5, 16);
        bool stiff = subject.Kind == LocomotionKind.Swimming && rig.Joints.Length == 1;
        head = stiff ? new GazeSettings(rate, FishYaw, FishPitch, FishPitch) : new GazeSettings(rate);
        lids = Eyelids.Of(rig.Skeleton, rig.Head);
        ears = Ears.Of(rig.Skeleton, rig.Head);
        flicks = habits.Child("ears");
        flickPeriod = (float)Scalar.Clamp(2.5 * PortableMath.Pow(mass, 0.08), 1.5, 6);

        // Seconds from blink to blink: 4 for a cat, 5 for a dog, 9 for a cow.
        blinkPeriod = (float)Scalar.Clamp(3 * PortableMath.Pow(mass, 0.165), 2, 12);
    }

    /// <summary>Asks memory for what it remembers.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() => MemoryLines.Touch(ref seconds) ^ MemoryLines.Touch(ref state);

    /// <summary>How lids and ears are held; null when the creature blinks and flicks its ears by itself.</summary>
    public StandingAct? Held { get; set; }

    /// <summary>How far an act or a mood shuts the lids: 0 as at rest, 1 shut, below 0 wide open. Blinks shut what is left.</summary>
    public float Lids { get; set; }

    /// <summary>Whether the body is limp: its lids sink from where they are, it does not blink, and how it held its head is part of how it lies.</summary>
    public bool IsLimp
    {
        get => isLimp;
        set
        {
            (state, slack) = value && !isLimp ? (default, shown) : (state, slack);
            isLimp = value;
        }
    }

    /// <summary>Turns head and eyes.</summary>
    /// <param name="target">A point in the world to look at; null for none.</param>
    /// <param name="settings">How they follow; null for what suits the creature.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="speed">Metres per second.</param>
    /// <param name="weight">A factor on looking about.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="local">The pose, its lids at rest; head, neck, eyes and lids are turned.</param>
    /// <param name="model">The same in model space.</param>
    public void Update(Vector3? target, in GazeSettings? settings, in RootPlace root, float speed, float weight, float dt, in Pose local, in Pose model)
    {
        seconds += dt;
        bool still = weight > 0f && System.Math.Abs(speed) < Still;
        float shut = lids == null ? 0f : Shut(dt);
        if (shut != 0f)
        {
            lids!.Close(shut, local, model);
        }

        float flicking = still ? System.Math.Min(weight, 1f) : 0f;
        flickWeight = Scalar.Clamp(flicking, flickWeight - (FlickFade * dt), flickWeight + (FlickFade * dt));
        if (ears != null && (Held == null ? flickWeight > 0f : still))
        {
            ears.Flick(Held ?? Flicked(flickWeight), local, model);
        }

        GazeTarget wanted = GazeTarget.None;
        if (target is Vector3 point)
        {
            wanted = GazeTarget.At(root.ToModel(point));
        }
        else if (still)
        {
            var glances = new GlanceSettings(System.Math.Min(0.85f * weight, 1.2f), System.Math.Min(0.2f * weight, 0.5f), 2.2f);

            // About where the motion holds the head, however it holds the trunk.
            LookAngles glance = Glances.At(habits, seconds, glances);
            wanted = GazeTarget.Towards(glance with { Pitch = glance.Pitch + GazeSolver.PitchOf(rig, model) });
        }

        if (wanted.Kind == GazeTargetKind.None && state.Weight == 0f)
        {
            return;
        }

        GazeSolver.Advance(rig, ref state, settings ?? head, wanted, dt, local, model);
        if (rig.LeftEye >= 0 && rig.RightEye >= 0)
        {
            Eyes.Update(rig, ref state, EyeSettings.Default, wanted, dt, local, model);
        }
    }

    /// <summary>How far lids are shut: held by the game, or by act, mood and limpness, and what is left by blinks.</summary>
    private float Shut(float dt)
    {
        if (IsLimp || slack != 0f)
        {
            slack += ((IsLimp ? LimpLids : 0f) - slack) * (1f - (float)PortableMath.Exp(-SlackRate * dt));
            slack = slack < SlackRate * 1e-4f && !IsLimp ? 0f : slack;
        }

        float shut = slack + ((1f - slack) * Lids);
        float blink = Held?.Lids ?? (IsLimp ? 0f : System.Math.Max(Blinks.At(blinks, seconds, blinkPeriod), Blinks.Once((seconds - winced) / WinceLength)));
        float wanted = shut + ((1f - shut) * blink);
        shown = Held == null && isShown ? Scalar.Clamp(wanted, shown - (FastestLid * dt), shown + (FastestLid * dt)) : wanted;
        isShown = true;
        return shown;
    }

    private StandingAct Flicked(float weight)
    {
        (float left, float right) = EarFlicks.At(flicks, seconds, flickPeriod);
        return new StandingAct(0f, left * weight, right * weight);
    }

    /// <summary>Shuts its eyes for a moment, as who is struck does.</summary>
    public void Wince() => winced = seconds;

    /// <summary>Looks straight ahead again, at once.</summary>
    public void Reset()
    {
        state = default;
        (slack, shown, isShown) = (0f, 0f, false);
        flickWeight = 0f;
        winced = double.NegativeInfinity;
    }
}
