using CreatureGen.Motion;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>Ground in checks, as it is drawn.</summary>
internal interface IFloor
{
    /// <summary>The floor as a camera sees it, in its axes.</summary>
    /// <param name="camera">Where that is, world space.</param>
    /// <param name="frame">The axes that the checks stay in: those of the world, or of a platform.</param>
    RenderMesh At(in RootPlace camera, in RootPlace frame);
}
