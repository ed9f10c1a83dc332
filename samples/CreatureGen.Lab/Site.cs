using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text.Json;

namespace CreatureGen.Lab;

/// <summary>The files of the page, as the build lays them out.</summary>
internal sealed class Site
{
    /// <summary>The creature that is seen while the runtime starts, as it breathes: the one that the page begins with.</summary>
    private const string FirstMovingFile = "first-moving.png";

    /// <summary>The same where motion is not wanted.</summary>
    private const string FirstStillFile = "first.png";

    /// <summary>The list of all files, for visits without a network.</summary>
    private const string ListFile = "files.json";

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

        string list = Path.Combine(Folder, ListFile);
        string[] makers = [typeof(CreatureGenerator).Assembly.Location, typeof(Site).Assembly.Location, .. Directory.EnumerateFiles(Folder, "*", SearchOption.AllDirectories)];
        if (!File.Exists(list) || makers.Any(maker => maker != list && File.GetLastWriteTimeUtc(maker) > File.GetLastWriteTimeUtc(list)))
        {
            (byte[] still, byte[] moving) = FirstCreature.Pictures();
            File.WriteAllBytes(Path.Combine(Folder, FirstStillFile), still);
            File.WriteAllBytes(Path.Combine(Folder, FirstMovingFile), moving);
            Stills.Write(Path.Combine(Folder, Stills.FolderName));
            WriteList();
        }
    }

    /// <summary>Lists all files with a number that changes when one of them does.</summary>
    private void WriteList()
    {
        using var sum = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        List<string> names = [];
        foreach (string file in Directory.EnumerateFiles(Folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            string name = Path.GetRelativePath(Folder, file).Replace('\\', '/');
            if (name is not ListFile and not "sw.js")
            {
                names.Add(name);
                sum.AppendData(File.ReadAllBytes(file));
            }
        }

        File.WriteAllText(Path.Combine(Folder, ListFile), JsonSerializer.Serialize(new { version = Convert.ToHexStringLower(sum.GetHashAndReset())[..12], files = names }));
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
