using System.Collections.Generic;
using System.Threading;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Films;

/// <summary>A moving picture with a strip that tells it on one sheet.</summary>
public interface IFilm
{
    /// <summary>Frames of the moving picture.</summary>
    int FrameCount { get; }

    /// <summary>How long a frame shows.</summary>
    int MillisecondsPerFrame { get; }

    /// <summary>What happens in it, at its own seconds: for its sound.</summary>
    IReadOnlyList<ClipEvent> Events { get; }

    /// <summary>A frame of the moving picture.</summary>
    /// <param name="index">0 up to <see cref="FrameCount"/>.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">There is no such frame.</exception>
    Picture Frame(int index);

    /// <summary>The strip.</summary>
    /// <exception cref="System.OperationCanceledException">It was stopped.</exception>
    Picture Strip(CancellationToken cancellation = default);
}
