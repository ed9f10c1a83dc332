using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>
/// A creature that obeys a script of commands, as a moving picture from its first to its last command, and as a strip that shows the transitions: pictures close together after each command, the root's
/// path from above, speeds asked and gone, and when each foot was down. Pictures may be made in any order and on any threads; they are the same every time.
/// </summary>
public sealed class CourseFilm : IFilm
{
    /// <summary>Longest script that is filmed, seconds.</summary>
    public const double MaxSeconds = 60;

    private const int AtlasSize = 512;
    private const int FramesPerSecond = 20;

    // Parts of the creature's length: side of a check, and how far the floor goes.
    private const float CheckPart = 0.14f;
    private const float FloorPart = 1.1f;
    private const int PatchesPerCheck = 4;

    // Degrees up to which a camera goes that looks over ground that rises towards it.
    private const double HighestElevation = 50;

    // Every so manieth vertex and moment is looked at to find out how much room the creature takes.
    private const int Sparsely = 9;

    private readonly RenderMesh dressed;
    private readonly IFloor? floor;
    private readonly WaterSheet? water;
    private readonly Dictionary<(View View, CameraTurn Turning), CameraAngle> angles;
    private readonly Vector3[] stillRoom;
    private readonly Vector3[] turningRoom;

    /// <summary>Takes the film.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="script">What is asked of it, at most <see cref="MaxSeconds"/>.</param>
    /// <param name="ground">What it goes over.</param>
    /// <param name="options">How the film is made; its relief is not used.</param>
    /// <exception cref="ArgumentException">An option is out of its range, or the script is too long.</exception>
    public CourseFilm(MotionProfile profile, CourseScript script, CourseGround ground, FilmOptions options)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(script);
        ArgumentNullException.ThrowIfNull(options);
        Film.CheckRange(options.Width, nameof(options.Width));
        Film.CheckRange(options.Height, nameof(options.Height));
        if (script.Seconds > MaxSeconds)
        {
            throw new ArgumentOutOfRangeException(nameof(script), script.Seconds, FormattableString.Invariant($"expected at most {MaxSeconds} seconds"));
        }

        Profile = profile;
        Ground = ground;
        Options = options;
        Take = new CourseTake(profile, script, ground);
        RenderMesh bare = RenderMesh.From(profile.Subject.Creature!);
        dressed = options.Shading is ShadingMode.Flat or ShadingMode.Faceted ? bare : bare.WithTextures(Creatures.CreatureTextures.Bake(profile.Subject.Creature!, AtlasSize));
        stillRoom = FindRoom(CameraTurn.Still);
        turningRoom = FindRoom(CameraTurn.Along);
        floor = profile.Swim == null ? FloorAround() : null;
        water = Take.Water is { } wet ? new WaterSheet(wet, FloorPart * turningRoom.Max(point => point.Z) * 2f) : null;
        angles = FindAngles();
    }

    /// <summary>The creature's profile.</summary>
    public MotionProfile Profile { get; }

    /// <summary>What it goes over.</summary>
    public CourseGround Ground { get; }

    /// <summary>How the film is made.</summary>
    public FilmOptions Options { get; }

    /// <summary>Frames of the moving picture.</summary>
    public int FrameCount => 1 + ((Take.Moments - 1) / MomentsPerFrame);

    /// <summary>How long a frame shows.</summary>
    public int MillisecondsPerFrame => 1000 / FramesPerSecond;

    internal CourseTake Take { get; }

    /// <inheritdoc/>
    public IReadOnlyList<ClipEvent> Events => Take.Events;

    private static int MomentsPerFrame => CourseTake.Rate / FramesPerSecond;

    /// <summary>A frame of the moving picture: the camera goes along, and turns along if it is asked to.</summary>
    /// <param name="index">0 up to <see cref="FrameCount"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public Picture Frame(int index)
    {
        if ((uint)index >= (uint)FrameCount)
        {
            throw new ArgumentOutOfRangeException(nameof(index), index, FormattableString.Invariant($"expected 0..{FrameCount - 1}"));
        }

        int moment = index * MomentsPerFrame;
        Picture frame = Draw(moment, Options.View, Options.Camera, Options.Width, Options.Height);
        string command = Take.Script.Commands[Take.CommandAt(moment)].ToString();
        Label.Draw(frame, Label.Fit(FormattableString.Invariant($"{moment / (double)CourseTake.Rate:0.0} s  {command}"), LabelSize.Small, Options.Width - 16), 8, 8, LabelSize.Small, new Pixel(24, 27, 32));
        return frame;
    }

    /// <summary>The strip.</summary>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public Picture Strip(CancellationToken cancellation = default) => CourseStrip.Draw(this, cancellation);

    /// <summary>Room that the creature takes as a camera sees it, metres.</summary>
    internal Vector3 RoomSize(CameraTurn turning) => BoundingBox.Of(turning == CameraTurn.Along ? turningRoom : stillRoom).Size;

    /// <summary>The creature on its ground at a moment.</summary>
    internal Picture Draw(int moment, View view, CameraTurn turning, int width, int height)
    {
        RootPlace place = Take.CameraAt(moment, turning);

        // From above on floors, level at walls, from below under ceilings.
        CameraAngle angle = angles[(view, turning)];
        angle = angle with { ElevationDegrees = angle.ElevationDegrees * Take.UpAt(place.Position).Y };
        var camera = Camera.Fit(angle, turning == CameraTurn.Along ? turningRoom : stillRoom, width / (float)height);
        (Vector3[] positions, Vector3[] normals) = Take.SkinAt(moment, place);
        RenderMesh mesh = dressed.Posed(positions, normals);
        var options = new RenderOptions
        {
            Width = width,
            Height = height,
            Shading = Options.Shading,
            Samples = SampleCount.Four,
            Ground = GroundKind.None,
        };
        RenderMesh scene = floor == null ? mesh : mesh.With(floor.At(place, Take.FrameAt(moment)));
        Picture picture = Renderer.Render(scene, camera, options);
        if (water != null)
        {
            WaterSheet.Lay(picture, Renderer.Render(scene.With(water.At(place)), camera, options));
        }

        ContactMarks.Draw(picture, Profile.Legs, Take.MarksAt(moment, place), camera);
        return picture;
    }

    /// <summary>From where each view looks: over ground that rises towards the camera from so much higher, so that it does not hide who is on it.</summary>
    private Dictionary<(View, CameraTurn), CameraAngle> FindAngles()
    {
        var found = new Dictionary<(View, CameraTurn), CameraAngle>();
        bool even = floor == null || Ground is CourseGround.Flat or CourseGround.Lift or CourseGround.Pipe;
        foreach (View view in Enum.GetValues<View>())
        {
            foreach (CameraTurn turning in Enum.GetValues<CameraTurn>())
            {
                CameraAngle level = Views.Angle(view);
                double rise = even ? 0 : Take.SteepestRise(level.AzimuthDegrees, turning, FloorPart * RoomSize(CameraTurn.Along).Z, Sparsely);
                found[(view, turning)] = level with { ElevationDegrees = Math.Max(level.ElevationDegrees, Math.Min(level.ElevationDegrees + rise, HighestElevation)) };
            }
        }

        return found;
    }

    private Vector3[] FindRoom(CameraTurn turning)
    {
        var points = new List<Vector3>();
        for (int moment = 0; moment < Take.Moments; moment += Sparsely)
        {
            Vector3[] skin = Take.SkinAt(moment, Take.CameraAt(moment, turning)).Positions;
            for (int v = 0; v < skin.Length; v += Sparsely)
            {
                points.Add(skin[v]);
            }
        }

        return [.. points];
    }

    private IFloor FloorAround()
    {
        float length = turningRoom.Max(point => point.Z) - turningRoom.Min(point => point.Z);
        float tread = CourseSurfaces.CheckLength(Profile);
        bool even = Ground is CourseGround.Flat or CourseGround.Lift;

        // Checks end where steps do.
        return Take.Floor(even ? CheckPart * length : tread, even ? 1 : PatchesPerCheck, FloorPart * length);
    }
}
