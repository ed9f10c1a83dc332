using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>The heights around a root between which ground counts.</summary>
/// <param name="Root">Where the body is.</param>
/// <param name="Up">Unit, world space.</param>
/// <param name="Ground">What is felt.</param>
/// <param name="Above">Where rays begin above the root, metres of the model.</param>
/// <param name="Below">How far below it they end.</param>
internal readonly record struct GroundRange(RootPlace Root, Vector3 Up, IGround Ground, float Above, float Below)
{
    /// <summary>Whether there is ground at a place.</summary>
    /// <param name="place">Model space; its height does not count.</param>
    /// <param name="height">Of the ground above the root, metres of the model.</param>
    public bool Has(Vector3 place, out float height)
    {
        Vector3 from = Root.ToWorld(new Vector3(place.X, Above, place.Z));
        bool found = Ground.Cast(from, -Up, (Above + Below) * Root.Scale, out GroundHit hit);
        height = found ? Vec.Dot(hit.Point - Root.Position, Up) / Root.Scale : 0f;
        return found;
    }
}
