namespace CreatureGen.Motion.Gaits;

/// <summary>The numbers of a gait that pass over smoothly into those of the next one.</summary>
internal struct GaitShape
{
    /// <summary>Part of the way to a gait that is left out: without, numbers that go to 0 would change for ever, and with them all that is worked out anew where they do.</summary>
    private const float Nothing = 1e-4f;

    public float Lift;
    public float Track;
    public float Crouch;
    public float ForceDip;
    public float Bounce;
    public float BounceCap;
    public float Emphasis;
    public float ForeBias;
    public float HindBias;
    public float Lean;
    public float ElbowBend;
    public float Tuck;
    public float Trail;
    public float Stretch;
    public float Rock;
    public float Arch;

    /// <summary>The gait that it goes to, and which part of the way there is left.</summary>
    private Gait? goal;
    private float left;

    public static GaitShape Of(Gait gait) => new()
    {
        Lift = gait.Lift,
        Track = gait.Track,
        Crouch = gait.Crouch,
        ForceDip = gait.ForceDip,
        Bounce = gait.Bounce,
        BounceCap = gait.BounceCap,
        Emphasis = gait.Emphasis,
        ForeBias = gait.ForeBias,
        HindBias = gait.HindBias,
        Lean = gait.Lean,
        ElbowBend = gait.ElbowBend,
        Tuck = gait.Tuck,
        Trail = gait.Trail,
        Stretch = gait.Stretch,
        Rock = gait.Rock,
        Arch = gait.Arch,
        goal = gait,
    };

    /// <summary>Goes a share of the way to those of a gait.</summary>
    public void Approach(Gait gait, float fraction)
    {
        if (!ReferenceEquals(gait, goal))
        {
            (goal, left) = (gait, 1f);
        }

        if (left == 0f)
        {
            return;
        }

        left -= left * fraction;
        if (left < Nothing)
        {
            this = Of(gait);
            return;
        }

        Lift += (gait.Lift - Lift) * fraction;
        Track += (gait.Track - Track) * fraction;
        Crouch += (gait.Crouch - Crouch) * fraction;
        ForceDip += (gait.ForceDip - ForceDip) * fraction;
        Bounce += (gait.Bounce - Bounce) * fraction;
        BounceCap += (gait.BounceCap - BounceCap) * fraction;
        Emphasis += (gait.Emphasis - Emphasis) * fraction;
        ForeBias += (gait.ForeBias - ForeBias) * fraction;
        HindBias += (gait.HindBias - HindBias) * fraction;
        Lean += (gait.Lean - Lean) * fraction;
        ElbowBend += (gait.ElbowBend - ElbowBend) * fraction;
        Tuck += (gait.Tuck - Tuck) * fraction;
        Trail += (gait.Trail - Trail) * fraction;
        Stretch += (gait.Stretch - Stretch) * fraction;
        Rock += (gait.Rock - Rock) * fraction;
        Arch += (gait.Arch - Arch) * fraction;
    }
}
