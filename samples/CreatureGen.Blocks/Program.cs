using System;
using System.IO;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;

namespace CreatureGen.Blocks;

/// <summary>Writes a picture of each sample into a folder.</summary>
internal static class Program
{
    private static int Main(string[] arguments)
    {
        string folder = arguments.Length > 0 ? arguments[0] : ".";
        Directory.CreateDirectory(folder);
        Save("gecko", Gecko.Strip());
        Save("chains", Chains.Strip());
        Save("ponytail", Ponytail.Strip());
        Save("footfalls", Footfalls.Plot());
        Save("blends", Blends.Strip());
        Save("puppet", Puppet.Strip());
        Save("hound", Hound.Strip());
        Save("stranger", Stranger.Strip());
        Save("borrowed", Borrowed.Strip());
        Save("guest", Guest.Strip());
        return 0;

        void Save(string name, Picture picture)
        {
            string path = Path.Combine(folder, name + ".png");
            File.WriteAllBytes(path, PngWriter.ToBytes(picture));
            Console.WriteLine(path);
        }
    }
}
