using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How far hind and fore body come down so that no standing leg reaches beyond its share of the reach, or up so that none is folded beyond the limit of its knee.</summary>
internal struct LegRoom
{
    /// <summary>Part of its reach beyond which a standing leg draws the body down.</summary>
    private const float MaxStretch = 0.972f;

    /// <summary>Part of its reach beyond which a leg that leaves the ground lets itself be stretched where another is folded up; one that stands is stretched to its end.</summary>
    private const float Spare = 0.1f;

    /// <summary>Part of its reach over which a leg begins to draw the body down, and one to raise it.</summary>
    private const float Width = 0.01f;

    private const float FoldedWidth = 0.02f;

    /// <summary>How far a leg draws the body down at most, leg lengths. Legs out to the side gain less by it.</summary>
    private const float MaxDrop = 0.15f;

    /// <summary>How far a folded leg raises it at most.</summary>
    private const float MaxRaise = 0.35f;

    private const float LateralDrop = 0.05f;

    /// <summary>Part of a swing in which its leg stops drawing the body down.</summary>
    private const float LettingGo = 0.25f;

    /// <summary>Part of a swing from which on its leg draws the body to where it will stand: in less time a knee near straight that stands beside it snaps.</summary>
    private const float Arriving = 0.6f;

    private const float LateralArriving = 0.75f;

    /// <summary>Part of a stance after which a stretched leg lets others raise the body more and more.</summary>
    private const float RollsOff = 0.6f;

    private readonly LeggedBody body;
    private Girdle hind;
    private Girdle fore;

    public LegRoom(LeggedBody body)
    {
        this.body = body;
        hind = Girdle.Free;
        fore = Girdle.Free;
    }

    /// <summary>How much a leg counts, 0..1: less as it leaves the ground, more as it comes down, and not where an act has taken it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Weight(LegRig leg, in Foot foot) => Math.Max(Arrival(leg, foot), Leaving(foot)) * (1f - foot.Taken);

    /// <summary>Adds what a leg asks that counts.</summary>
    /// <param name="leg">The leg.</param>
    /// <param name="chord">From its hip to what it reaches for, the body not lowered yet.</param>
    /// <param name="foot">Its foot; takes note of the chord and of what was asked.</param>
    /// <param name="dt">Seconds since the chord before.</param>
    public void Add(LegRig leg, Vector3 chord, ref Foot foot, float dt)
    {
        float weight = Weight(leg, foot);
        float arriving = Arrival(leg, foot);
        if (dt > 0f)
        {
            bool stood = foot.Phase == FootPhase.Stance && !foot.Plan.Arrived && foot.Leg.Astray == Vector3.Zero;
            foot.Leg.Drift = stood ? (chord - foot.Leg.Chord) / dt : default;
        }

        foot.Leg.Chord = chord;
        float distance = Vec.Length(chord);
        float steep = Steepness(chord, distance);
        float max = (leg.Lateral ? LateralDrop : MaxDrop) * leg.Length;
        float asked = Math.Min(Asked(leg, chord, distance), max);

        // One that has left the ground draws the body no farther down than it did there.
        bool leaves = foot.Phase == FootPhase.Swing && arriving == 0f;
        float drawn = leaves ? Math.Min(asked, foot.Leg.Drawn) : asked;
        foot.Leg.Drawn = leaves ? foot.Leg.Drawn : weight * asked;
        float drop = weight * drawn;
        float raise = weight * Math.Min(Beyond(leg.FoldedReach - distance, FoldedWidth * leg.Reach) / steep, MaxRaise * leg.Length);
        foot.Leg.Held = foot.Phase == FootPhase.Swing ? foot.Leg.Held : Standing(foot);
        float holds = Math.Max(arriving, foot.Leg.Held * Leaving(foot));
        float room = Math.Max(((1f + (Spare * (1f - holds))) * leg.Reach) - distance, 0f);

        // How far down it can be folded: farther its foot would be pushed into the ground.
        float depth = (Math.Max(distance - leg.FoldedReach, 0f) / steep) + ((1f - weight) * MaxDrop * leg.Length);

        // Bodies on many legs come down level.
        if (body.Rows != 2 || leg.Row == 0)
        {
            hind.Add(drop, raise, room, depth);
        }

        if (body.Rows != 2 || leg.Row == 1)
        {
            fore.Add(drop, raise, room, depth);
        }
    }

    /// <summary>Finds how far the body comes down when all legs that count have been added.</summary>
    /// <param name="feet">All; take note of it.</param>
    /// <param name="dt">Seconds since it was last found.</param>
    /// <param name="way">How far an act takes the trunk, metres.</param>
    /// <param name="tilt">How steeply the ground goes from hind to fore feet, parts of the length of the trunk: one end alone that comes down swings its hips away from its feet, so that the other goes along as far as that.</param>
    /// <param name="drop">How far it had come down then; goes on.</param>
    /// <param name="hindDrop">Of the hind body, metres; negative is up.</param>
    /// <param name="foreDrop">Of the fore body.</param>
    public readonly void Find(Span<Foot> feet, float dt, Vector3 way, float tilt, ref LegDrop drop, out float hindDrop, out float foreDrop)
    {
        float level = Math.Max(1f - body.Span.Fraction, Math.Min(tilt, 1f));
        float hindest = Math.Max(hind.Drop, level * fore.Drop);
        hindDrop = Net(hindest, hind.Rise);
        foreDrop = Net(Math.Max(fore.Drop, level * hindest), fore.Rise);
        drop.Follow(dt, body.LegLength, way, ref hindDrop, ref foreDrop);
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i].Leg.Lowered = body.Legs[i].IsHind(body.Rows) ? hindDrop : foreDrop;
        }
    }

    /// <summary>How far a leg asks the body to come down, metres.</summary>
    /// <param name="leg">The leg.</param>
    /// <param name="chord">From its hip to what it reaches for, the body not lowered yet.</param>
    /// <param name="distance">Length of that.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Asked(LegRig leg, Vector3 chord, float distance) => Beyond(distance - (MaxStretch * leg.Reach), Width * leg.Reach) / Steepness(chord, distance);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Steepness(Vector3 chord, float distance) => Math.Max(-chord.Y / Math.Max(distance, 1e-6f), 0.35f);

    /// <summary>How far a girdle comes down: what a folded leg asks for comes before what a stretched one does.</summary>
    private static float Net(float drop, float rise) => Math.Max(drop - (2f * rise), -rise);

    /// <summary>How much a leg counts that leaves the ground, 0..1: less and less.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Leaving(in Foot foot) => foot.Phase == FootPhase.Stance ? 1f : 1f - Scalar.Smooth(foot.Swing / LettingGo);

    /// <summary>How much one counts that comes down, 0..1: more and more.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Arrival(LegRig leg, in Foot foot)
    {
        float from = leg.Lateral ? LateralArriving : Arriving;
        return foot.Phase == FootPhase.Stance ? 0f : Scalar.Smooth((foot.Swing - from) / (1f - from));
    }

    /// <summary>How much a standing leg holds the body down, 0..1: it may stretch as its foot rolls off.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Standing(in Foot foot) => 1f - Scalar.Smooth((foot.Stance - RollsOff) / (1f - RollsOff));

    /// <summary>What an excess comes to: softened, so that the body does not jerk as a leg comes to its end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Beyond(float excess, float width)
    {
        if (excess < -4f * width)
        {
            return 0f;
        }

        float soft = 0.5f * (excess + (float)Math.Sqrt((excess * excess) + (width * width))) - (0.5f * (-4f * width + (float)Math.Sqrt(17f) * width));
        return Math.Max(soft, 0f);
    }

    /// <summary>What the legs of a girdle ask.</summary>
    private struct Girdle
    {
        private float drop;
        private float raise;
        private float room;
        private float depth;

        /// <summary>Of no legs.</summary>
        public static Girdle Free => new() { room = float.MaxValue, depth = float.MaxValue };

        /// <summary>How far it comes down, metres: no farther than the others fold.</summary>
        public readonly float Drop => Math.Min(drop, depth);

        /// <summary>How far it comes up: no farther than the others reach.</summary>
        public readonly float Rise => Math.Min(raise, room);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(float drop, float raise, float room, float depth)
        {
            this.drop = Math.Max(this.drop, drop);
            this.raise = Math.Max(this.raise, raise);
            this.room = Math.Min(this.room, room);
            this.depth = Math.Min(this.depth, depth);
        }
    }
}
