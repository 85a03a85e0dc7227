"""What all figures have in common: how programs are run, and how their pictures become figures."""

import json
import os
import subprocess
import sys

from PIL import Image, ImageDraw

MODELS = ("fandisk", "elephant")  # each stage is shown on these two: a part with sharp edges, and an animal
LARGEST_PICTURE = 150000          # bytes
CAPTION = 16                      # pixels


class Maker:
    """Runs the programs of a folder on models, and writes figures."""

    def __init__(self, programs, meshes, figures, folder):
        self.programs, self.meshes, self.figures, self.folder = programs, meshes, figures, folder
        self.runs = 0

    def model(self, name):
        return os.path.join(self.meshes, name + ".off")

    def file(self, name):
        """A name for a file that is gone in the end."""
        return os.path.join(self.folder, name)

    @staticmethod
    def open(path):
        return Image.open(path).convert("RGB")

    def run(self, program, *arguments, may_fail=False):
        """Runs a program; where it fails the figures are not made."""
        command = [os.path.join(self.programs, program)] + [str(a) for a in arguments]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False)
        if done.returncode > (1 if may_fail else 0):
            sys.exit("%s\nends with %d: %s" % (" ".join(command), done.returncode, done.stdout))
        return done.stdout

    def picture(self, program, *arguments, may_fail=False):
        """The picture that a program draws."""
        self.runs += 1
        path = self.file("picture_%d.png" % self.runs)
        self.run(program, *arguments, "--picture", path, may_fail=may_fail)
        return self.open(path)

    def quads(self, model, *options, may_fail=False):
        """The picture of `quadrangulate` with options, for the name of a model or a file; the quads stand in quads.obj."""
        path = model if os.path.exists(model) else self.model(model)
        return self.picture("quadrangulate", path, self.file("quads.obj"), *options, may_fail=may_fail)

    def figures_of(self, model, *options):
        """Picture and figures of a run, also of one whose result is not valid."""
        image = self.quads(model, "--json", self.file("figures.json"), *options, may_fail=True)
        return image, self.json("figures.json")

    def json(self, name):
        with open(self.file(name), encoding="utf-8") as file:
            return json.load(file)

    def sheet(self, name, rows, size=(480, 360), captions=None):
        """Writes pictures in rows and columns, with captions below the columns or, a list for each row, below each of them."""
        width, height = size
        deep = height + (CAPTION if captions else 0)
        sheet = Image.new("RGB", (max(map(len, rows)) * width, len(rows) * deep), (255, 255, 255))
        for j, row in enumerate(rows):
            for i, image in enumerate(row):
                sheet.paste(image.resize(size, Image.LANCZOS), (i * width, j * deep))
                if captions:
                    text = captions[j][i] if isinstance(captions[0], (list, tuple)) else captions[i]
                    ImageDraw.Draw(sheet).text((i * width + 6, j * deep + height), text, fill=(0, 0, 0))
        self.save(sheet, name)

    def save(self, image, name):
        """Writes a picture of so few colors that it is small, and smaller if that is not enough."""
        path = os.path.join(self.figures, name + ".png")
        while image.width > 200:
            for colors in (256, 128, 64, 32):
                image.quantize(colors, dither=0).save(path, optimize=True)
                if os.path.getsize(path) <= LARGEST_PICTURE:
                    print("%s: %d x %d, %d colors" % (path, image.width, image.height, colors))
                    return
            image = image.resize((image.width * 7 // 8, image.height * 7 // 8), Image.LANCZOS)
        sys.exit("%s has more than %d bytes" % (path, LARGEST_PICTURE))


def read_off(path):
    """Points and faces of a text OFF file."""
    with open(path, encoding="ascii") as file:
        words = [w for line in file for w in line.split("#")[0].split()]
    number_of_points, number_of_faces = int(words[1]), int(words[2])
    points = [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(number_of_points)]
    faces, at = [], 4 + 3 * number_of_points
    for _ in range(number_of_faces):
        size = int(words[at])
        faces.append([int(w) for w in words[at + 1:at + 1 + size]])
        at += 1 + size
    return points, faces


def write_off(path, points, faces):
    with open(path, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        file.writelines("%r %r %r\n" % tuple(p) for p in points)
        file.writelines(" ".join(map(str, [len(f)] + list(f))) + "\n" for f in faces)


def write_lines(path, rows):
    """A file of numbers, a row a line."""
    with open(path, "w", encoding="ascii") as file:
        file.writelines(" ".join("%r" % x for x in row) + "\n" for row in rows)
    return path
