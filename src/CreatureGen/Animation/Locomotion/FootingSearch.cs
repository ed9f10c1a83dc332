using System;
using System.Numerics;
using CreatureGen.Animation.Grounds;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Locomotion;

/// <summary>Finds ground for a foot: below where it wants to go, or nearby when there is a gap, an edge or a wall; and what stands in its way.</summary>
internal sealed class FootingSearch
{
    /// <summary>Where rays begin above the ground of the body, part of the leg's length: steps up to this height are taken.</summary>
    private const float Above = 0.8f;

    /// <summary>How far below the ground of the body a foot finds footing, part of the leg's length.</summary>
    private const float Below = 0.9f;

    /// <summary>Least cosine of a slope that holds a foot (60°).</summary>
    private const float Steepest = 0.5f;

    /// <summary>Drop at toe or heel that counts as an edge, part of the leg's length.</summary>
    private const float EdgeDrop = 0.12f;

    private static readonly (float Ahead, float In)[] alternatives = { (-0.2f, 0f), (0.2f, 0f), (0f, 0.2f), (-0.4f, 0f), (0.4f, 0f), (-0.6f, 0f), (0f, -0.2f) };

    private readonly LeggedBody body;

    public FootingSearch(LeggedBody body) => this.body = body;

    /// <summary>Finds a place for a foot.</summary>
    /// <param name="step">The moment.</param>
    /// <param name="leg">Whose foot.</param>
    /// <param name="wanted">Under the ball, model space; its height does not count.</param>
    /// <param name="yaw">Heading of the foot there, radians from the body's.</param>
    /// <param name="nudge">Shift along the foot that keeps it off an edge; carried on from update to update.</param>
    /// <param name="place">The place; its heading is not set.</param>
    /// <returns>Whether there is ground.</returns>
    public bool Find(in StepContext step, int leg, Vector3 wanted, float yaw, ref float nudge, out FootPlace place)
    {
        LegShape shape = body.Legs[leg];
        Vector3 up = step.Settings.Up;
        PortableMath.SinCos(yaw, out double sine, out double cosine);
        var ahead = new Vector3((float)sine, 0f, (float)cosine);
        Vector3 target = wanted + (ahead * nudge);
        bool found = Down(step, target, out GroundHit hit);
        if (!found)
        {
            for (int i = 0; i < alternatives.Length && !found; i++)
            {
                Vector3 inward = new Vector3(ahead.Z, 0f, -ahead.X) * (shape.Home.X > 0f ? -1f : 1f);
                target = wanted + (((ahead * alternatives[i].Ahead) + (inward * alternatives[i].In)) * shape.Length);
                found = Down(step, target, out hit);
            }
        }

        if (!found)
        {
            place = new FootPlace { Position = step.Frame.ToWorld(new Vector3(wanted.X, 0f, wanted.Z)), Normal = up };
            return false;
        }

        place = new FootPlace { Position = hit.Point, Normal = hit.Normal, Surface = hit.Surface, Platform = hit.Platform };
        if (!(step.Ground is FlatGround))
        {
            KeepOffEdges(step, shape, target, ahead, hit, ref nudge);
        }

        return true;
    }

    /// <summary>Looks for what a swinging foot has to be lifted over.</summary>
    public void Obstacles(in StepContext step, ref Foot foot)
    {
        if (step.Ground is FlatGround)
        {
            return;
        }

        // One ray at a time, at places that change with the progress of the swing.
        float at = foot.Swing < 0.15f ? 0.35f : foot.Swing < 0.3f ? 0.5f : foot.Swing < 0.45f ? 0.65f : 0.8f;
        Vector3 from = step.Frame.ToModel(foot.From.Position);
        Vector3 to = step.Frame.ToModel(foot.To.Position);
        Vector3 between = Vec.Lerp(from, to, at);
        if (Down(step, between, out GroundHit hit))
        {
            float height = step.Frame.ToModel(hit.Point).Y - between.Y;
            foot.Bump = Math.Max(foot.Bump, Math.Min(height, 0.6f * body.LegLength));
        }
    }

    /// <summary>Moves a foot back from an edge under its toes, or ahead from one under its heel, a little in each update.</summary>
    private void KeepOffEdges(in StepContext step, LegShape shape, Vector3 target, Vector3 ahead, in GroundHit hit, ref float nudge)
    {
        float most = 0.5f * (shape.Toe + shape.Heel);
        float drop = EdgeDrop * shape.Length * step.Frame.Scale;
        bool toes = Hangs(step, target + (ahead * (0.9f * shape.Toe)), hit, drop);
        bool heel = Hangs(step, target - (ahead * (0.9f * shape.Heel)), hit, drop);
        if (toes != heel)
        {
            nudge = Scalar.Clamp(nudge + (toes ? -0.25f * most : 0.25f * most), -1.5f * most, 1.5f * most);
        }
    }

    private bool Hangs(in StepContext step, Vector3 point, in GroundHit under, float drop)
    {
        if (!Down(step, point, out GroundHit hit))
        {
            return true;
        }

        return Vec.Dot(under.Point - hit.Point, step.Settings.Up) > drop + (2f * Vec.Length(Vec.Reject(under.Point - hit.Point, step.Settings.Up)));
    }

    private bool Down(in StepContext step, Vector3 point, out GroundHit hit)
    {
        float above = Above * body.LegLength;
        Vector3 up = step.Settings.Up;
        Vector3 origin = step.Frame.ToWorld(new Vector3(point.X, above, point.Z));
        return step.Ground.Cast(origin, -up, (above + (Below * body.LegLength)) * step.Frame.Scale, out hit) && Vec.Dot(hit.Normal, up) > Steepest;
    }
}
