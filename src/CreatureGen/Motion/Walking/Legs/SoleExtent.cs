using System;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>How far a foot's sole reaches on the ground, ahead of the ball and behind it, metres.</summary>
internal readonly struct SoleExtent
{
    /// <summary>Height below which skin is sole, part of the ball's height.</summary>
    private const float SoleFraction = 0.55f;

    /// <summary>Layer above its lowest point that counts as the sole's surface, part of the leg's length.</summary>
    private const float LayerFraction = 0.02f;

    /// <summary>Height up to which a foot runs against what stands at its ends, part of the leg's length.</summary>
    private const float BumpFraction = 0.06f;

    /// <summary>Weight from which on a vertex is of the foot alone.</summary>
    private const float Firm = 0.9f;

    /// <summary>Cotangent of the tilt at which what is farthest out of a sole is looked for, 27°.</summary>
    private const float Tilted = 2f;

    /// <summary>Turns a direction by an eighth of a circle.</summary>
    private const float OneOverRootTwo = 0.70710678f;

    /// <summary>Directions in which its outline is measured.</summary>
    public const int Directions = 8;

    private SoleExtent(float toe, float heel, (float Fore, float Aft) bumpers, float width, Vector3 middle, Rim rim, ToeTip tip)
    {
        Toe = toe;
        Heel = heel;
        Fore = Math.Max(toe, bumpers.Fore);
        Aft = Math.Max(heel, bumpers.Aft);
        HalfWidth = width;
        Middle = middle;
        Outline = rim.Points;
        Hinder = rim.Hinder;
        Tip = tip;
    }

    /// <summary>From the ball to what of the sole's surface is farthest out and down in each of so many directions, level; and how high that is above the ground.</summary>
    public Vector3[] Outline { get; }

    /// <summary>Which of these the ankle moves and not the ball, a bit for each.</summary>
    public int Hinder { get; }

    /// <summary>From the ball to the middle of the sole's surface, level.</summary>
    public Vector3 Middle { get; }

    public float Toe { get; }

    public float Heel { get; }

    /// <summary>How far the foot reaches ahead of the ball above its sole, too, as high as what it may run against.</summary>
    public float Fore { get; }

    /// <summary>The same behind the ball: a heel or a spur that is carried clear of level ground.</summary>
    public float Aft { get; }

    /// <summary>From the line through the ball to the farther side.</summary>
    public float HalfWidth { get; }

    /// <summary>The end of the toes over which it rolls.</summary>
    public ToeTip Tip { get; }

    /// <summary>Measures the soles of all legs on the skin.</summary>
    public static SoleExtent[] Measure(MotionSubject subject, LimbChain[] legs)
    {
        Skeleton skeleton = subject.Skeleton;
        int[] legOf = new int[skeleton.Count];
        Array.Fill(legOf, -1);
        var ahead = new Vector3[legs.Length];
        var balls = new Vector3[legs.Length];
        var heights = new float[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            Vector3 ball = skeleton.ModelPositions[legs[i].Joints[4]];
            balls[i] = ball;
            heights[i] = Vec.Distance(skeleton.ModelPositions[legs[i].Joints[1]], new Vector3(ball.X, 0f, ball.Z));
            Vector3 toes = skeleton.ModelPositions[legs[i].Joints[5]] - ball;
            toes.Y = 0f;
            ahead[i] = Vec.Normalize(toes, Vector3.UnitZ);
            for (int k = 3; k <= 5; k++)
            {
                legOf[legs[i].Joints[k]] = i;
            }
        }

        var toe = new float[legs.Length];
        var heel = new float[legs.Length];
        var bumpers = new (float Fore, float Aft)[legs.Length];
        var width = new float[legs.Length];
        var sum = new Vector3[legs.Length];
        var count = new int[legs.Length];
        var surface = new float[legs.Length];
        Array.Fill(surface, float.MaxValue);
        ReadOnlySpan<SkinWeights> weights = subject.Mesh.Weights;
        ReadOnlySpan<Vector3> positions = subject.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            int leg = legOf[weights[v].Joint0];
            if (leg < 0)
            {
                continue;
            }

            Vector3 ball = balls[leg];
            float along = Vec.Dot(positions[v] - ball, ahead[leg]);
            if (positions[v].Y < BumpFraction * heights[leg])
            {
                bumpers[leg] = (Math.Max(bumpers[leg].Fore, along), Math.Max(bumpers[leg].Aft, -along));
            }

            if (positions[v].Y > SoleFraction * ball.Y)
            {
                continue;
            }

            toe[leg] = Math.Max(toe[leg], along);
            heel[leg] = Math.Max(heel[leg], -along);
            width[leg] = Math.Max(width[leg], Math.Abs(((positions[v].X - ball.X) * ahead[leg].Z) - ((positions[v].Z - ball.Z) * ahead[leg].X)));
            if (weights[v].Weights.X > Firm)
            {
                surface[leg] = Math.Min(surface[leg], positions[v].Y);
            }
        }

        var tips = new ToeTip.Profile[legs.Length];
        int[] ankles = Array.ConvertAll(legs, leg => leg.Joints[3]);
        bool[] creased = Array.ConvertAll(legs, leg => LegGaitParameters.Of(leg.Archetype!.Value).Kind.Outline.End == FootEnd.Toes);
        Rim[] rims = Array.ConvertAll(ahead, _ => new Rim());
        for (int v = 0; v < positions.Length; v++)
        {
            int leg = legOf[weights[v].Joint0];
            if (leg < 0)
            {
                continue;
            }

            Vector3 ball = balls[leg];
            bool firm = weights[v].Weights.X > Firm;
            bool hinder = weights[v].Joint0 == ankles[leg];
            if (firm && !hinder)
            {
                tips[leg].Add(Vec.Dot(positions[v] - ball, ahead[leg]), positions[v].Y);
            }

            bool down = positions[v].Y < surface[leg] + (LayerFraction * heights[leg]);
            if (down && (firm || !(hinder && creased[leg])) && WeightOf(weights[v], legOf, leg) > Firm)
            {
                // Skin between its joints is sole as well, but for the crease in which a heel rises from toes.
                rims[leg].Widen(ahead[leg], new Vector3(positions[v].X - ball.X, positions[v].Y, positions[v].Z - ball.Z), hinder);
            }

            if (down && firm)
            {
                sum[leg] += positions[v] - ball;
                count[leg]++;
            }
        }

        var extents = new SoleExtent[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            extents[i] = new SoleExtent(toe[i], heel[i], bumpers[i], width[i], count[i] > 0 ? sum[i] / count[i] : ahead[i] * (0.5f * (toe[i] - heel[i])), rims[i], tips[i].Fit(toe[i]));
        }

        return extents;
    }

    /// <summary>How much a foot moves a vertex, 0..1.</summary>
    private static float WeightOf(in SkinWeights w, int[] legOf, int leg) =>
        (legOf[w.Joint0] == leg ? w.Weights.X : 0f) + (legOf[w.Joint1] == leg ? w.Weights.Y : 0f) + (legOf[w.Joint2] == leg ? w.Weights.Z : 0f) + (legOf[w.Joint3] == leg ? w.Weights.W : 0f);

    /// <summary>The rim of a sole as it is found, place by place.</summary>
    private sealed class Rim
    {
        private readonly float[] farthest = new float[Directions];

        public Rim() => Array.Fill(farthest, float.MinValue);

        public Vector3[] Points { get; } = new Vector3[Directions];

        public int Hinder { get; private set; }

        /// <summary>Lets it go as far out and down as a place of the sole: to where it would touch the ground if it were tilted that way.</summary>
        /// <param name="ahead">Where the toes point, level, unit.</param>
        /// <param name="place">From the ball, its height above the ground.</param>
        /// <param name="hinder">Whether the ankle moves it and not the ball.</param>
        public void Widen(Vector3 ahead, Vector3 place, bool hinder)
        {
            Vector3 direction = ahead;
            for (int i = 0; i < Points.Length; i++)
            {
                float far = Vec.Dot(direction, place) - (Tilted * place.Y);
                if (far > farthest[i])
                {
                    (Points[i], farthest[i]) = (place, far);
                    Hinder = hinder ? Hinder | (1 << i) : Hinder & ~(1 << i);
                }

                direction = Vec.Scale(new Vector3(direction.X + direction.Z, 0f, direction.Z - direction.X), OneOverRootTwo);
            }
        }
    }
}
