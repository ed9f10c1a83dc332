using CreatureGen.Motion;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>How a <see cref="Film"/> is made.</summary>
public sealed record FilmOptions
{
    /// <summary>Width of a frame, pixels, 32..4096.</summary>
    public int Width { get; init; } = 640;

    /// <summary>Height of a frame, pixels, 32..4096.</summary>
    public int Height { get; init; } = 480;

    /// <summary>From where the moving picture is taken; the film strip has a side and a front of its own.</summary>
    public View View { get; init; } = View.ThreeQuarter;

    /// <summary>Whether the camera of a <see cref="CourseFilm"/> turns along with the creature.</summary>
    public CameraTurn Camera { get; init; } = CameraTurn.Still;

    /// <summary>What the creature goes on. Of what flies and swims nothing is seen below.</summary>
    public GroundRelief Ground { get; init; } = GroundRelief.Flat;

    /// <summary>How surfaces are coloured.</summary>
    public ShadingMode Shading { get; init; } = ShadingMode.Smooth;

    /// <summary>Threads that share the pictures of a strip, at least 1. It is the same for any number.</summary>
    public int Threads { get; init; } = 1;
}
