namespace CreatureGen.Motion;

/// <summary>The gaits that the library brings. Lags are those of touchdown, part of a cycle, rear left foot first; sources are in docs/gaits.md.</summary>
public static class GaitLibrary
{
    private static readonly DutyLaw walking = new(Intercept: 0.78f, Slope: 0.36f, Min: 0.54f, Max: 0.75f);
    private static readonly DutyLaw running = new(Intercept: 0.52f, Slope: 0.12f, Min: 0.30f, Max: 0.48f);
    private static readonly DutyLaw galloping = new(Intercept: 0.40f, Slope: 0.075f, Min: 0.20f, Max: 0.34f);

    /// <summary>Four-beat walk: left hind, left fore, right hind, right fore.</summary>
    public static Gait Walk { get; } = new("Walk", new ListedPhases(0f, 0.5f, 0.25f, 0.75f), walking, StrideLaw.Symmetric)
    {
        MinRows = 2, MaxRows = 2, Comfortable = 0.12f, Fastest = 0.6f, Lift = 0.85f, Track = 0.88f, ForceDip = 0.5f, BounceCap = 0.022f, Emphasis = 1.3f,
    };

    /// <summary>Four-beat walk of primates: left hind, right fore, right hind, left fore.</summary>
    public static Gait DiagonalWalk { get; } = Walk with { Name = "DiagonalWalk", Phases = new ListedPhases(0f, 0.5f, 0.75f, 0.25f) };

    /// <summary>Fast walk without a bounce: elephants.</summary>
    public static Gait Amble { get; } = Walk with { Name = "Amble", MaxRows = int.MaxValue, Comfortable = 0.3f, Fastest = 1f, Lift = 0.9f, Track = 0.85f, Crouch = 0.02f, ForceDip = 0.1f };

    /// <summary>Walk of sprawlers: diagonal feet nearly together, the fore foot a little later.</summary>
    public static Gait Crawl { get; } = new("Crawl", new ListedPhases(0f, 0.5f, 0.42f, 0.92f), walking, StrideLaw.Symmetric)
    {
        MinRows = 2, MaxRows = 2, Comfortable = 0.12f, Fastest = 0.5f, Crouch = 0.01f, ForceDip = 0.1f, BounceCap = 0.022f, Emphasis = 1.15f, ForeBias = 0f, HindBias = 0f,
    };

    /// <summary>Diagonal feet together; of more than four legs every other one.</summary>
    public static Gait Trot { get; } = new("Trot", new ListedPhases(0f, 0.5f, 0.5f, 0f), running, StrideLaw.Symmetric)
    {
        MinRows = 2, Comfortable = 0.8f, Fastest = 2.5f, Lift = 1.15f, Track = 0.78f, Crouch = 0.03f, ForeBias = 0f, HindBias = 0f,
    };

    /// <summary>Trot of sprawlers: feet stay longer on the ground.</summary>
    public static Gait SprawlTrot { get; } = Trot with { Name = "SprawlTrot", Duty = new DutyLaw(Intercept: 0.60f, Slope: 0.12f, Min: 0.40f, Max: 0.56f), Comfortable = 0.5f, Fastest = 1.5f, Lift = 1f, Track = 0.9f, Crouch = 0.01f, BounceCap = 0.022f };

    /// <summary>Feet of one side together, of any number of pairs.</summary>
    public static Gait Pace { get; } = new("Pace", new ListedPhases(0f, 0.5f, 0.04f, 0.54f), running, StrideLaw.Symmetric)
    {
        MinRows = 2, Comfortable = 0.8f, Fastest = 2.2f, Lift = 0.95f, Track = 0.72f, Crouch = 0.025f, ForceDip = 0.1f, BounceCap = 0.03f, Emphasis = 1.1f,
    };

    /// <summary>Three-beat canter: right hind, then left hind with right fore, then left fore.</summary>
    public static Gait Canter { get; } = new("Canter", new SpreadPhases(0.30f, 0f, 0.66f, 0.34f), new DutyLaw(Intercept: 0.50f, Slope: 0.10f, Min: 0.34f, Max: 0.42f), StrideLaw.Asymmetric)
    {
        MinRows = 2, Comfortable = 1.6f, Fastest = 3.5f, Lift = 1.35f, Track = 0.78f, Crouch = 0.045f, Bounce = 0.75f, BounceCap = 0.075f, Symmetry = GaitSymmetry.Leading, ForeBias = 0f, HindBias = 0f,
    };

    /// <summary>Gallop in which hind and fore feet follow in the same order: horses.</summary>
    public static Gait TransverseGallop { get; } = new("TransverseGallop", new SpreadPhases(0.12f, 0f, 0.60f, 0.47f), galloping, StrideLaw.Asymmetric)
    {
        MinRows = 2, Comfortable = 3f, Fastest = 14f, Lift = 1.55f, Track = 0.72f, Crouch = 0.06f, Bounce = 0.75f, BounceCap = 0.075f, Symmetry = GaitSymmetry.Leading, ForeBias = 0f, HindBias = 0f,
    };

    /// <summary>Gallop in which the feet follow round the body: dogs and cats.</summary>
    public static Gait RotaryGallop { get; } = TransverseGallop with { Name = "RotaryGallop", Phases = new SpreadPhases(0.08f, 0f, 0.50f, 0.60f), Fastest = 18f };

    /// <summary>Hind feet together, then fore feet together.</summary>
    public static Gait Bound { get; } = new("Bound", new SpreadPhases(0.03f, 0f, 0.50f, 0.46f), galloping, StrideLaw.Asymmetric)
    {
        MinRows = 2, Comfortable = 2.2f, Fastest = 10f, Lift = 1.6f, Crouch = 0.06f, Bounce = 0.75f, BounceCap = 0.075f, ForeBias = 0f, HindBias = 0f,
    };

    /// <summary>All four feet together, high on straight legs, the back arched in the air: gazelles.</summary>
    public static Gait Pronk { get; } = new("Pronk", new ListedPhases(0f, 0f, 0f, 0f), new DutyLaw(Intercept: 0.40f, Slope: 0.08f, Min: 0.22f, Max: 0.36f), new StrideLaw(2.2f, 0.40f))
    {
        MinRows = 2, MaxRows = 2, Comfortable = 1.2f, Fastest = 5f, Lift = 1f, Track = 0.95f, Crouch = 0.05f, Bounce = 0.9f, BounceCap = 0.34f, ForeBias = 0f, HindBias = 0f, Stretch = 0.9f, Arch = 0.22f,
    };

    /// <summary>Walk on two legs.</summary>
    public static Gait BipedWalk { get; } = new("BipedWalk", new ListedPhases(0f, 0.5f), walking, StrideLaw.Symmetric)
    {
        MaxRows = 1, Comfortable = 0.15f, Fastest = 0.6f, Lift = 0.9f, Track = 0.62f, Crouch = 0.02f, ForceDip = 0.4f, BounceCap = 0.022f, Emphasis = 1.3f, HindBias = 0f,
    };

    /// <summary>Run on two legs.</summary>
    public static Gait BipedRun { get; } = new("BipedRun", new ListedPhases(0f, 0.5f), running, StrideLaw.Symmetric)
    {
        MaxRows = 1, Comfortable = 1f, Fastest = 10f, Lift = 1.4f, Track = 0.45f, Crouch = 0.05f, HindBias = -0.07f, Lean = 3f, ElbowBend = 0.5f,
    };

    /// <summary>Short steps on short legs, the body rolled over the foot that carries it: penguins.</summary>
    public static Gait Waddle { get; } = BipedWalk with { Name = "Waddle", Stride = new StrideLaw(1.6f, 0.30f), Comfortable = 0.08f, Fastest = 0.35f, Lift = 0.5f, Track = 0.85f };

    /// <summary>The same in a hurry: quicker steps.</summary>
    public static Gait WaddleRun { get; } = Waddle with { Name = "WaddleRun", Duty = new DutyLaw(Intercept: 0.60f, Slope: 0.14f, Min: 0.46f, Max: 0.58f), Comfortable = 0.35f, Fastest = 1f, Lift = 0.55f, Track = 0.8f, ForceDip = 0f };

    /// <summary>Both feet together: kangaroos. The tail counters the legs.</summary>
    public static Gait Hop { get; } = new("Hop", new ListedPhases(0f, 0f), new DutyLaw(Intercept: 0.40f, Slope: 0.07f, Min: 0.21f, Max: 0.36f), new StrideLaw(2.3f, 0.40f))
    {
        MaxRows = 1, Comfortable = 1.4f, Fastest = 8f, Lift = 2.6f, Track = 0.95f, Crouch = 0.045f, Bounce = 0.85f, BounceCap = 0.34f, HindBias = 0f, Lean = 6f, ElbowBend = 0.6f, Trail = 0.85f, Stretch = 0.9f, Rock = 0.15f,
    };

    /// <summary>The hind pair pushes, all other legs catch: grasshoppers and frogs.</summary>
    public static Gait Leap { get; } = new("Leap", new LeapPhases(), new DutyLaw(Intercept: 0.32f, Slope: 0.06f, Min: 0.20f, Max: 0.30f), new StrideLaw(2.6f, 0.40f))
    {
        MinRows = 2, Comfortable = 0.6f, Fastest = 4f, Lift = 1.2f, Track = 0.95f, Crouch = 0.02f, Bounce = 0.75f, BounceCap = 0.35f, ForeBias = 0f, HindBias = 0f, Tuck = 0.8f, Trail = 1f,
    };

    /// <summary>Steps run along the body from the rear, each leg a swing later than the one behind it: one leg after the other when slow, tetrapod, tripod when fast. For any number of legs.</summary>
    public static Gait Wave { get; } = new("Wave", new WavePhases(WaveDirection.Forward), new DutyLaw(Intercept: 0.74f, Slope: 0.30f, Min: 0.50f, Max: 0.75f), StrideLaw.Symmetric)
    {
        MinRows = 3, Comfortable = 0.12f, Fastest = 1.2f, Crouch = 0f, Bounce = 0.6f, BounceCap = 0.022f, ForeBias = 0f, HindBias = 0f,
    };

    /// <summary>Two sets of alternate legs: insects in a hurry.</summary>
    public static Gait Tripod { get; } = Wave with { Name = "Tripod", Duty = new DutyLaw(Intercept: 0.55f, Slope: 0.03f, Min: 0.50f, Max: 0.55f), Phases = new WavePhases(WaveDirection.Forward), Comfortable = 0.35f, Fastest = 2.5f };

    /// <summary>Four of six legs down.</summary>
    public static Gait Tetrapod { get; } = Wave with { Name = "Tetrapod", Duty = new DutyLaw(Intercept: 0.67f, Slope: 0f, Min: 0.67f, Max: 0.67f), Comfortable = 0.1f, Fastest = 0.6f };

    /// <summary>One leg of a side after the other: five of six down.</summary>
    public static Gait SlowWave { get; } = Wave with { Name = "SlowWave", Duty = new DutyLaw(Intercept: 0.83f, Slope: 0f, Min: 0.83f, Max: 0.83f), Comfortable = 0.03f, Fastest = 0.2f };

    /// <summary>Waves that run to the rear: centipedes.</summary>
    public static Gait BackwardWave { get; } = Wave with { Name = "BackwardWave", Phases = new WavePhases(WaveDirection.Backward) };
}
