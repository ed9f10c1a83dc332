using System;
using System.IO;
using System.Linq;

namespace CreatureGen.Lab;

/// <summary>The files of the page, as the build lays them out.</summary>
internal sealed class Site
{
    /// <summary>The creature that is seen while the runtime starts: the one that the page begins with.</summary>
    private const string FirstCreatureFile = "first.bin";

    public Site(string folder) => Folder = folder;

    public string Folder { get; }

    /// <summary>Sees that the page is there and writes what the library itself makes for it.</summary>
    /// <exception cref="InvalidOperationException">The page was not built.</exception>
    public void Prepare()
    {
        if (!File.Exists(Path.Combine(Folder, "index.html")))
        {
            throw new InvalidOperationException("the page is not built; expected Node.js 20 or later and npm, which build it when this project is built. Install Node.js and run the same command again.");
        }

        string first = Path.Combine(Folder, FirstCreatureFile);
        string library = typeof(CreatureGenerator).Assembly.Location;
        if (!File.Exists(first) || File.GetLastWriteTimeUtc(first) < File.GetLastWriteTimeUtc(library) || File.GetLastWriteTimeUtc(first) < File.GetLastWriteTimeUtc(typeof(Site).Assembly.Location))
        {
            File.WriteAllBytes(first, FirstCreature.Bake());
        }
    }

    /// <summary>Copies all files to a folder; others that are there stay.</summary>
    /// <returns>How many.</returns>
    public int Export(string folder)
    {
        string[] files = [.. Directory.EnumerateFiles(Folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal)];
        foreach (string file in files)
        {
            string target = Path.Combine(folder, Path.GetRelativePath(Folder, file));
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            File.Copy(file, target, overwrite: true);
        }

        return files.Length;
    }
}
