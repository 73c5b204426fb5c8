using System;
using FastPoints.Drawing;
using FastPoints.Entities;
using UnityEngine;

namespace FastPoints.Samples.AttributeColours
{
    /// <summary>Buttons that change what a cloud's points are coloured by, and which classes it shows. Each change streams
    /// another plane: bytes that no colour needs are not read.</summary>
    [RequireComponent(typeof(PointCloud))]
    [AddComponentMenu("FastPoints/Samples/Colour Switch")]
    public sealed class ColourSwitch : MonoBehaviour
    {
        /// <summary>Classes of the sample's street by their ASPRS numbers: ground, plants and buildings.</summary>
        static readonly (int Class, string Name)[] s_classes = { (2, "ground"), (5, "high vegetation"), (6, "building") };

        static readonly ColorMode[] s_modes = (ColorMode[])Enum.GetValues(typeof(ColorMode));
        static readonly ColorRamp[] s_ramps = (ColorRamp[])Enum.GetValues(typeof(ColorRamp));

        void OnGUI()
        {
            var cloud = GetComponent<PointCloud>();
            foreach (var mode in s_modes)
                if (GUILayout.Toggle(cloud.Color == mode, mode.ToString()))
                    cloud.Color = mode;
            foreach (var ramp in s_ramps)
                if (GUILayout.Toggle(cloud.ColorRamp == ramp, "Ramp " + ramp))
                    cloud.ColorRamp = ramp;
            foreach (var (number, name) in s_classes)
                Show(number, GUILayout.Toggle(!IsHidden(cloud, number), "Show " + name));
        }

        /// <summary>Shows or hides the points of a class.</summary>
        public void Show(int number, bool isShown)
        {
            var cloud = GetComponent<PointCloud>();
            if (IsHidden(cloud, number) != isShown)
                return;
            var hidden = cloud.HiddenClasses;
            cloud.HiddenClasses = isShown ? Array.FindAll(hidden, c => c != number) : Append(hidden, number);
        }

        static bool IsHidden(PointCloud cloud, int number) => Array.IndexOf(cloud.HiddenClasses, number) >= 0;

        static int[] Append(int[] classes, int number)
        {
            Array.Resize(ref classes, classes.Length + 1);
            classes[classes.Length - 1] = number;
            return classes;
        }
    }
}
