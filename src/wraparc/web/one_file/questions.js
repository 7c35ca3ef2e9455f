// What only a server answers is not asked in the file.
export const questions = () => null;
