using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;

namespace CreatureGen.Tests.Golden;

/// <summary>Golden files for another process to print, in a temporary folder of their own: every fourth of their entries, or all of them. The process of the tests compares all.</summary>
internal sealed class GoldenSample : IDisposable
{
    private static readonly int step = Thoroughness.IsExhaustive ? 1 : 4;

    public GoldenSample()
    {
        Entries = Some(GoldenFile.Entries);
        string poses = PoseEntry.Format("", Some(PoseEntry.Parse(RepositoryFiles.Text(GoldenFile.PosesPlace))));
        string assets = string.Concat(Some(AssetEntry.Parse(RepositoryFiles.Text(GoldenFile.AssetsPlace))).Select(entry => entry + "\n"));
        Others = poses + assets;
        File.WriteAllText(FilePath, GoldenEntry.Format("", Entries));
        File.WriteAllText(Path.Combine(Folder, "poses.txt"), poses);
        File.WriteAllText(Path.Combine(Folder, "assets.txt"), assets);
    }

    /// <summary>The entries of creatures.</summary>
    public IReadOnlyList<GoldenEntry> Entries { get; }

    /// <summary>The text of the entries of poses, then of those of assets.</summary>
    public string Others { get; }

    public string Folder { get; } = Directory.CreateTempSubdirectory("creaturegen-golden-").FullName;

    /// <summary>The file of creatures.</summary>
    public string FilePath => Path.Combine(Folder, "golden.txt");

    public void Dispose() => Directory.Delete(Folder, recursive: true);

    private static T[] Some<T>(IEnumerable<T> entries) => entries.Where((_, i) => i % step == 0).ToArray();
}
