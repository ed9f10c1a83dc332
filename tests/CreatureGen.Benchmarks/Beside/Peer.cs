using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>A library in C++ that is built from a checkout beside this one, with a program of ours that times it.</summary>
/// <param name="Name">Its name, and its checkout's folder.</param>
/// <param name="Program">Our program.</param>
/// <param name="Includes">Folders of the checkout in which headers are found.</param>
/// <param name="Sources">Folders of the checkout all of whose sources are compiled, and single sources.</param>
internal sealed record Peer(string Name, string Program, string[] Includes, string[] Sources)
{
    private const string Programs = "tests/CreatureGen.Benchmarks/Peers";

    /// <summary>Simplification and order of triangles.</summary>
    public static Peer Meshoptimizer { get; } = new("meshoptimizer", "meshoptimizer.cpp", new[] { "src" }, new[] { "src" });

    /// <summary>Clips, poses, limbs, skinning.</summary>
    public static Peer Ozz { get; } = new("ozz-animation", "ozz.cpp", new[] { "include", "src" }, new[]
    {
        "src/animation/runtime", "src/base", "src/base/containers", "src/base/encode", "src/base/io", "src/base/maths", "src/base/memory", "src/geometry/runtime",
        "src/animation/offline/animation_builder.cc", "src/animation/offline/raw_animation.cc", "src/animation/offline/raw_animation_utils.cc", "src/animation/offline/raw_skeleton.cc", "src/animation/offline/skeleton_builder.cc",
    });

    /// <summary>All of them.</summary>
    public static Peer[] All { get; } = { Meshoptimizer, Ozz };

    /// <summary>Builds its program with the machine's compiler and all optimisations.</summary>
    /// <param name="checkouts">The folder in which its checkout is.</param>
    /// <param name="workFolder">Where the program comes to be.</param>
    /// <returns>The program.</returns>
    /// <exception cref="InvalidOperationException">It does not build.</exception>
    public string Build(string checkouts, string workFolder)
    {
        string checkout = Path.Combine(checkouts, Name);
        string program = Path.Combine(workFolder, Path.GetFileNameWithoutExtension(Program));
        IEnumerable<string> arguments = new[] { "-O3", "-w", "-std=c++17", Path.Combine(ProbeBuild.Root, Programs, Program), "-o", program }
            .Concat(Includes.SelectMany(folder => new[] { "-I", Path.Combine(checkout, folder) }))
            .Concat(Sources.SelectMany(source => Files(Path.Combine(checkout, source))));
        ProbeBuild.Run("g++", workFolder, arguments.ToArray());
        return program;
    }

    /// <summary>Whether there is a checkout of it.</summary>
    public bool IsIn(string checkouts) => Directory.Exists(Path.Combine(checkouts, Name));

    private static IEnumerable<string> Files(string source) => File.Exists(source) ? new[] { source } : Directory.GetFiles(source, "*.cc").Concat(Directory.GetFiles(source, "*.cpp")).Order(StringComparer.Ordinal);
}
